#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "data/grains.h"
#include "data/input_error.h"
#include "data/remarks/remark.h"

namespace pendular {

/// Condition of the grains in one measured or simulated state, which is either steady shear or a
/// point of failure (peak of the shear stress).
struct Condition {
    double normal_stress = 0;           ///< s22, imposed on the grains [Pa]
    double inertial_number = 0;         ///< I [1]; 0: quasi-static limit
    double liquid_content = 0;          ///< volume of liquid over that of grains [1]; 0: dry
    std::optional<double> height;       ///< of the sample [m]; empty: unknown
    std::optional<double> bead_volume;  ///< solid volume of the grains in the cell [m^3], if known
    double time = 0;          ///< since the start of the study's first recording [s]; 0: unknown
    bool at_failure = false;  ///< point of failure rather than steady shear
    /// Normal stress of the preshear before a point of failure [Pa], if known.
    std::optional<double> preshear_stress = {};
    /// Whether an ideal instrument shows the state: values predicted for it are those of the
    /// grains, without what effects of the instrument add.
    bool ideal_instrument = false;
    /// Relative change of the gap per unit of shear strain [1] while the torque was steady: the bed
    /// was not sheared throughout, so that its mean solid fraction is not that of the flow. 0: the
    /// gap became steady.
    double gap_creep = 0;

    bool dry() const { return liquid_content == 0; }
    bool operator==(const Condition&) const = default;
};

/// Contribution to the error of a reading that it has in common with other readings: the error of
/// one filling of the cell, or an error of rounding.
struct SharedError {
    /// Number of the cause. Shared errors with equal numbers are fully correlated.
    std::size_t source = 0;
    /// Standard errors of shear stress [Pa] (index 0) and solid fraction [1] (index 1), increased
    /// if they were estimated from few fillings.
    Eigen::Vector2d size = Eigen::Vector2d::Zero();
    /// Whether the size is known, as for an error of rounding or of a filling that a table states.
    /// Otherwise this is the error of a filling, whose variance `ReplicateScatter::filling`
    /// describes.
    bool known = false;
    bool of_rounding = false;
};

/// Measured state: a mean over a step of steady shear, or a point of failure. Vectors and matrices
/// have the shear stress [Pa] at index 0 and the solid fraction [1] at index 1.
///
/// `covariance` is the total error. It contains the `shared` errors and, as `widened_by`, an
/// increase for a scatter that was estimated from few replicates.
struct Reading {
    Position origin;    ///< file, with the first line that was used
    int last_line = 0;  ///< last line that was used; 0: the line in `origin`
    int step = 0;       ///< number of the step of constant set points, from 1; 0: unknown
    Condition condition;
    double shear_rate = 0;  ///< [1/s]; 0: only the inertial number was given
    Eigen::Vector2d value = Eigen::Vector2d::Zero();  ///< shear stress by its magnitude
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
    Eigen::Matrix2d widened_by = Eigen::Matrix2d::Zero();
    std::vector<SharedError> shared;
    /// Degrees of freedom of the estimated scatter between replicates; infinite if the covariance
    /// does not depend on an estimated scatter.
    Eigen::Vector2d scatter_freedom = Eigen::Vector2d::Constant(INFINITY);
    std::size_t scatter_group = 0;  ///< index of the file's group in `ReplicateScatter::groups`
    /// Unit of the last digit of the value in the table of readings; 0: not rounded.
    Eigen::Vector2d resolution = Eigen::Vector2d::Zero();
    double sampled_seconds = 0;  ///< duration of the averaged steady shear [s]; 0: unknown
    /// Whether the reading was averaged from a recording, which yields only the error from the
    /// scatter within one step. `pool_replicates` adds the scatter between steps and fillings.
    bool within_run_only = false;
    /// Whether the table of readings states no error of the value itself. `covariance` then holds
    /// only what follows from other columns, such as the error of the normal stress.
    std::array<bool, 2> unstated = {};
    /// Whether an unknown standard error was replaced by 2 % of the value.
    bool error_assumed = false;
    int replicates = 1;  ///< readings at nearly equal conditions (`are_replicates`), with this one

    /// Returns the covariance matrix without the increase for few replicates, for statistical tests
    /// that themselves allow for the small number of replicates.
    Eigen::Matrix2d estimated_covariance() const { return covariance - widened_by; }
    /// Returns the part of the variance that the reading shares with those of its filling: shear
    /// stress [Pa^2], solid fraction [1].
    Eigen::Vector2d filling_variance() const {
        Eigen::Vector2d sum = Eigen::Vector2d::Zero();
        for (const SharedError& error : shared)
            if (!error.of_rounding) sum += error.size.cwiseAbs2();
        return sum;
    }
    double stress_ratio() const { return value(0) / condition.normal_stress; }
    /// Whether the solid fraction tells nothing, since the gap crept.
    bool fraction_unknown() const { return condition.gap_creep != 0; }
    /// Returns a remark on the reading and its rows.
    Remark remark(Remark::Kind kind) const {
        return {.kind = kind,
                .files = {origin.file},
                .lines = {{origin.line, std::max(last_line, origin.line)}},
                .step = step};
    }
};

/// Scatter between replicates, estimated (`pool_replicates`) or stated by the user. Variances and
/// mean squares are relative [1]: divided by the square of the stress ratio (index 0) or of the
/// solid fraction (index 1).
struct ReplicateScatter {
    /// Files recorded at the same conditions, with the scatter between their repeated steps.
    struct Group {
        std::vector<std::string> files;  ///< paths
        /// Covariance matrix of the deviations between repeated steps at `reference_stress`, minus
        /// the contribution of the scatter within each step.
        Eigen::Matrix2d excess = Eigen::Matrix2d::Zero();
        /// Mean squares of the deviations between replicates at `reference_stress`, including the
        /// scatter within steps. Groups that share one estimate have equal mean squares.
        Eigen::Vector2d mean_square = Eigen::Vector2d::Zero();
        /// Degrees of freedom of `mean_square`: 0 without replicates, infinite if stated by the
        /// user.
        Eigen::Vector2d freedom = Eigen::Vector2d::Zero();
    };
    /// Groups of files that have conditions (normal stress, inertial number and liquid content) in
    /// common. Every file of the study is in one group.
    std::vector<Group> groups;
    /// Exponents [1] of the dependence of the scatter between repeated steps on the normal stress:
    ///     standard deviation ~ (normal stress/reference_stress)^-exponent
    Eigen::Vector2d load_exponent = Eigen::Vector2d::Zero();
    Eigen::Vector2d load_exponent_error = Eigen::Vector2d::Zero();  ///< 0: not estimated
    /// Degrees of freedom of the estimated correlation between the deviations of stress ratio and
    /// of solid fraction; infinite if the correlation was not estimated.
    double correlation_freedom = INFINITY;
    /// Geometric mean of the normal stresses of all readings [Pa].
    double reference_stress = 0;

    /// Error that all steps measured on one filling of the cell have in common, from a two-way
    /// analysis of variance (by conditions and by files):
    ///     variance = (between - within)/steps
    struct Filling {
        double variance = 0;  ///< increased if it was estimated from few fillings
        double between = 0;   ///< mean square between files, with a prior of one degree of freedom
        /// Residual mean square of single steps, after the means of conditions and of files were
        /// removed.
        double within = 0;
        /// Degrees of freedom of `between`, including the prior's: 0 if no two files have a
        /// condition in common, infinite if `variance` is treated as known, because the user stated
        /// the scatter or the files do not differ significantly.
        double freedom_between = 0;
        double freedom_within = 0;
        double steps = 1;  ///< effective number of conditions that two files have in common [1]
    };
    std::array<Filling, 2> filling;  ///< of the stress ratio and of the solid fraction
    bool stated = false;             ///< the user stated the scatter in [scatter] of study.toml
};

/// Readings of a study, and what was noticed about its data.
struct Measurements {
    /// In the order of the entries of study.toml, and of file names within one entry.
    std::vector<Reading> readings;
    ReplicateScatter scatter;  ///< included in the covariances of the readings
    std::vector<Remark> remarks;

    /// Returns the remarks with a consequence, such as all rows and readings that are left out.
    std::vector<Remark> with(Remark::Outcome outcome) const {
        std::vector<Remark> chosen;
        for (const Remark& remark : remarks)
            if (remark.outcome == outcome) chosen.push_back(remark);
        return chosen;
    }
    std::vector<Remark> left_out() const { return with(Remark::Outcome::left_out); }
    std::vector<Remark> notes() const { return with(Remark::Outcome::note); }
    /// Returns the warnings that values are probably wrong, whether or not they are used.
    std::vector<Remark> doubts() const {
        std::vector<Remark> chosen;
        for (const Remark& remark : remarks)
            if (remark.outcome == Remark::Outcome::kept ||
                remark.outcome == Remark::Outcome::set_aside)
                chosen.push_back(remark);
        return chosen;
    }
    /// Returns the faults inside recordings, such as a wobble of the lid, or those of whole files,
    /// such as a header that contradicts study.toml.
    std::vector<Remark> faults(bool inside_recordings) const {
        std::vector<Remark> chosen;
        for (const Remark& remark : with(Remark::Outcome::found))
            if (inside_recording(remark.kind) == inside_recordings) chosen.push_back(remark);
        return chosen;
    }
};

/// Returns the condition of each reading, in the order of the readings.
inline std::vector<Condition> conditions_of(const std::vector<Reading>& readings) {
    std::vector<Condition> conditions;
    for (const auto& reading : readings) {
        conditions.push_back(reading.condition);
    }
    return conditions;
}

}  // namespace pendular
