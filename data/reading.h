#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "data/grains.h"
#include "data/input_error.h"
#include "data/recordings/findings/file_finding.h"
#include "data/recordings/findings/finding.h"

namespace pendular {

/// Condition of the grains in one measured or simulated state: normal stress, inertial number and
/// liquid content and, if known, sample height, grain volume and time. The state is either steady
/// shear or a point of failure (peak of the shear stress).
struct Condition {
    double normal_stress = 0;    ///< normal stress s22 imposed on the grains [Pa]
    double inertial_number = 0;  ///< inertial number I of the flow [1]; 0: quasi-static limit
    /// Liquid content: volume of liquid divided by volume of grains [1]; 0: dry.
    double liquid_content = 0;
    std::optional<double> height;  ///< height of the sample at the condition [m]; empty: unknown
    std::optional<double> bead_volume;  ///< solid volume of the grains in the cell [m^3], if known
    /// Time at which the state was measured [s], from the start of the study's first recording; 0
    /// if unknown.
    double time = 0;
    /// Whether the state is a point of failure (peak of the shear stress) rather than steady shear.
    bool at_failure = false;
    /// Normal stress of the preshear that consolidated the sample before a point of failure [Pa],
    /// if known.
    std::optional<double> preshear_stress = {};
    /// Whether an ideal instrument shows the state: values predicted for it are those of the
    /// grains, without what effects of the instrument add.
    bool ideal_instrument = false;

    /// Whether the grains are dry: the liquid content is 0.
    bool dry() const { return liquid_content == 0; }
    bool operator==(const Condition&) const = default;
};

/// Contribution to the error of a reading (measured state) that the reading has in common with
/// other readings: the error of one filling of the cell, or an error of rounding.
struct SharedError {
    /// Number that identifies the cause of the shared error, such as a filling of the cell. Shared
    /// errors with equal numbers are fully correlated.
    std::size_t source = 0;
    /// Standard errors of the shear stress [Pa] (index 0) and of the solid fraction [1] (index 1)
    /// that the shared error causes. The standard errors are increased if they were estimated from
    /// few fillings of the cell.
    Eigen::Vector2d size = Eigen::Vector2d::Zero();
    /// Whether the size of the shared error is known, as for an error of rounding. Otherwise the
    /// shared error is the error of a filling, whose variance `ReplicateScatter::filling`
    /// describes.
    bool known = false;
};

/// Measured state: shear stress [Pa] and solid fraction [1] at one condition, with the covariance
/// of their errors. A reading is either the mean over a step of steady shear, or a point of
/// failure.
struct Reading {
    Position origin;  ///< file of the reading, with the first line that was used
    /// Last line of the file that was used for the reading; 0: equal to the line in `origin`.
    int last_line = 0;
    /// Number of the step of constant set points from which the reading was made. The steps of a
    /// file are counted from 1; 0: unknown.
    int step = 0;
    Condition condition;
    /// Shear rate of the reading [1/s]; 0: only the inertial number was given.
    double shear_rate = 0;
    /// Measured values of the reading: first the magnitude of the shear stress [Pa], second the
    /// solid fraction [1].
    Eigen::Vector2d value = Eigen::Vector2d::Zero();
    /// Covariance matrix of the total error of the reading. The first row and column are those of
    /// the shear stress [Pa], the second those of the solid fraction [1]. If the scatter between
    /// replicates (repeated readings at one condition) was estimated from few replicates, the
    /// contribution of the scatter is increased.
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
    /// Part of the reading's `covariance` that was added because the scatter between replicates
    /// (repeated readings at one condition) was estimated from few replicates. The first row and
    /// column are those of the shear stress [Pa], the second those of the solid fraction [1].
    Eigen::Matrix2d widened_by = Eigen::Matrix2d::Zero();
    /// Errors that the reading has in common with other readings, such as the error of one filling
    /// of the cell. The matrix `covariance` includes the shared errors.
    std::vector<SharedError> shared;
    /// Degrees of freedom of the estimated scatter between replicates (repeated readings at one
    /// condition), for the shear stress (index 0) and the solid fraction (index 1). The degrees of
    /// freedom are infinite if the covariance of the reading does not depend on an estimated
    /// scatter.
    Eigen::Vector2d scatter_freedom = Eigen::Vector2d::Constant(INFINITY);
    /// Index, in `ReplicateScatter::groups`, of the group of files that contains the reading's
    /// file.
    std::size_t scatter_group = 0;
    /// Rounding steps of the shear stress [Pa] (index 0) and of the solid fraction [1] (index 1). A
    /// rounding step is the unit of the last digit of the value in the table of readings, or 0 if
    /// the value was not rounded.
    Eigen::Vector2d resolution = Eigen::Vector2d::Zero();
    /// Duration of the steady shear over which the reading was averaged [s]; 0: unknown.
    double sampled_seconds = 0;
    /// Whether the reading was averaged from a recording (raw time series). The average itself
    /// yields only the error from the scatter within one step. The function `pool_replicates` adds
    /// the scatter between repeated steps and between fillings of the cell.
    bool within_run_only = false;
    /// Whether the standard error of the reading's shear stress or solid fraction was unknown, so
    /// that a standard error of 2 % of the value was assumed.
    bool error_assumed = false;
    /// Number of readings of the study at nearly equal conditions (`are_replicates`), including the
    /// reading itself.
    int replicates = 1;

    /// Returns the covariance matrix of the reading's errors without the increase for few
    /// replicates (repeated readings at one condition). The first row and column are those of the
    /// shear stress [Pa], the second those of the solid fraction [1]. The matrix is for statistical
    /// tests that themselves allow for the small number of replicates.
    Eigen::Matrix2d estimated_covariance() const { return covariance - widened_by; }
    /// Returns the stress ratio of the reading [1]: shear stress divided by normal stress.
    double stress_ratio() const { return value(0) / condition.normal_stress; }
};

/// Rows of a file, or a whole reading, that were left out, with the reason.
struct Excluded {
    /// Kind of the data that were left out. `rows` are rows of a file, such as a spike or a step in
    /// which the lid rests. `beside_plateau` are rows of a step outside of the steady part of the
    /// step, such as a transient. `step_without_plateau` is a whole step whose steady part is
    /// missing or too short. `reading` is a whole reading.
    enum class Kind { rows, beside_plateau, step_without_plateau, reading };
    Position origin;     ///< file and first line of the rows that were left out
    int last_line = 0;   ///< last line of the rows that were left out
    std::string reason;  ///< reason why the rows or the reading were left out, for the user
    Kind kind = Kind::rows;
    /// Reason without what is particular to one step, for messages on many steps: `what` is a
    /// clause such as "the normal force is negative", to be followed by "in all 30 steps"; `advice`
    /// says what to do. Empty for rows that are not a whole step.
    struct Cause {
        std::string what, advice;
    };
    Cause cause = {};
};

/// Statement that measured values are probably wrong, such as a solid fraction above that of the
/// densest packing, with the positions of the values.
struct Doubt {
    /// Message for the user about the doubtful values, with file, quantity, value, violated limit
    /// and likely cause.
    std::string what;
    /// Name of the quantity (`Quantity::name`) whose values are probably wrong, such as
    /// "solid_fraction".
    std::string quantity;
    /// Positions, in the measured files, of the readings or rows with the doubtful values.
    std::vector<Position> origins;
    /// Whether the readings or rows with the doubtful values were moved to
    /// `Measurements::excluded`, so that they are not used.
    bool set_aside = true;
};

/// Scatter between replicates (repeated readings at one condition), estimated or stated by the
/// user. Variances and mean squares are relative: for the stress ratio, they are divided by the
/// squared stress ratio, and for the solid fraction, by the squared solid fraction.
struct ReplicateScatter {
    /// Group of files that were recorded at the same conditions, with the scatter between their
    /// repeated steps (steps at the same set points).
    struct Group {
        std::vector<std::string> files;  ///< paths of the files in the group
        /// Covariance matrix [1] of the relative deviations between repeated steps at the normal
        /// stress `reference_stress`, minus the contribution of the scatter within each step. The
        /// first row and column are those of the stress ratio, the second those of the solid
        /// fraction.
        Eigen::Matrix2d excess = Eigen::Matrix2d::Zero();
        /// Mean squares [1] of the relative deviations between replicates (repeated readings at one
        /// condition) at the normal stress `reference_stress`, including the scatter within steps,
        /// for the stress ratio (index 0) and the solid fraction (index 1). Groups that share one
        /// estimate have equal mean squares.
        Eigen::Vector2d mean_square = Eigen::Vector2d::Zero();
        /// Degrees of freedom of `mean_square`, for the stress ratio (index 0) and the solid
        /// fraction (index 1). The degrees of freedom are 0 if the study has no replicates, and
        /// infinite if the user stated the scatter.
        Eigen::Vector2d freedom = Eigen::Vector2d::Zero();
    };
    /// Groups of files that have conditions (normal stress, inertial number and liquid content) in
    /// common. Every file of the study is in one group.
    std::vector<Group> groups;
    /// Exponents [1] that describe how the scatter between repeated steps depends on the normal
    /// stress, for the stress ratio (index 0) and the solid fraction (index 1).
    ///     standard deviation ~ (normal stress/reference_stress)^-exponent
    Eigen::Vector2d load_exponent = Eigen::Vector2d::Zero();
    /// Standard errors [1] of the exponents `load_exponent`, for the stress ratio (index 0) and the
    /// solid fraction (index 1); 0 if the exponents were not estimated.
    Eigen::Vector2d load_exponent_error = Eigen::Vector2d::Zero();
    /// Degrees of freedom of the estimated correlation between the deviations of stress ratio and
    /// of solid fraction; infinite if the correlation was not estimated.
    double correlation_freedom = INFINITY;
    /// Normal stress [Pa] at which the scatter between repeated steps has the covariance matrix
    /// `Group::excess`: geometric mean of the normal stresses of all readings.
    double reference_stress = 0;

    /// Error that all steps measured on one filling of the cell have in common, in stress ratio or
    /// in solid fraction. The variance of the error follows from a two-way analysis of variance (by
    /// conditions and by files):
    ///     variance = (between - within)/steps
    struct Filling {
        /// Variance of the filling error of the stress ratio or the solid fraction, divided by the
        /// squared stress ratio or solid fraction [1]. The variance is increased if it was
        /// estimated from few fillings.
        double variance = 0;
        /// Mean square of the relative deviations between files (fillings) [1]. The mean square
        /// includes a prior with one degree of freedom.
        double between = 0;
        /// Residual mean square [1] of the relative deviations of single steps, after the means of
        /// conditions and of files were removed.
        double within = 0;
        /// Degrees of freedom of the mean square `between`, including one for the prior. The
        /// degrees of freedom are 0 if no two files have a condition in common. The degrees of
        /// freedom are infinite if the program treats `variance` as known: the user stated the
        /// scatter, or the files do not differ significantly.
        double freedom_between = 0;
        double freedom_within = 0;  ///< degrees of freedom of the mean square `within`
        /// Effective number of conditions that two files (fillings) have in common [1].
        double steps = 1;
    };
    /// Errors of the fillings of the cell, in the stress ratio (index 0) and in the solid fraction
    /// (index 1).
    std::array<Filling, 2> filling;
    /// Whether the user stated the scatter between replicates (repeated readings at one condition)
    /// in the table [scatter] of study.toml.
    bool stated = false;
};

/// Readings of a study, the rows that were left out, and messages about values that are probably
/// wrong and about faults of the recordings.
struct Measurements {
    /// Readings in the order of the entries of study.toml. Readings of one entry are in the order
    /// of the file names.
    std::vector<Reading> readings;
    /// Scatter between replicates (repeated readings at one condition), which is included in the
    /// covariances of the readings.
    ReplicateScatter scatter;
    /// Rows of files, and whole readings, that were left out, with the reasons.
    std::vector<Excluded> excluded;
    /// Messages about measured values that are probably wrong, with the positions of the values.
    std::vector<Doubt> doubts;
    /// Faults found in the rows of the recordings, such as a wobble of the lid.
    std::vector<RecordingFinding> findings;
    /// Faults of whole files, such as a header that contradicts study.toml or measured values that
    /// do not follow their set points.
    std::vector<FileFinding> file_findings;
    /// Messages for the user about the conversion of files to readings, such as a torque whose sign
    /// was flipped.
    std::vector<std::string> notes;
    /// Message for the user that the model neglects the weight of the grains although the weight
    /// exceeds 10 % of the normal stress in some readings. The message is empty if the weight is
    /// small or if the model includes the weight.
    std::optional<std::string> weight_note;
};

/// Returns the imposed condition of each reading (measured state), in the order of the readings.
inline std::vector<Condition> conditions_of(const std::vector<Reading>& readings) {
    std::vector<Condition> conditions;
    for (const auto& reading : readings) {
        conditions.push_back(reading.condition);
    }
    return conditions;
}

}  // namespace pendular
