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

/// Conditions imposed on the grains in one measured or simulated state, which is either steady
/// shear or a point of failure.
struct Condition {
    double normal_stress = 0;      ///< normal stress s22 imposed on the grains [Pa]
    double inertial_number = 0;    ///< inertial number I of the flow [1]; 0: quasi-static limit
    double liquid_content = 0;     ///< volume of liquid divided by volume of grains [1]; 0: dry
    std::optional<double> height;  ///< height of the sample at this condition [m]; empty: unknown
    std::optional<double> bead_volume;  ///< solid volume of the grains in the cell [m^3], if known
    double time = 0;  ///< time of the state since the study's first recording began [s]
    /// Whether the state is a point of failure (peak of the shear stress) rather than steady shear.
    bool at_failure = false;
    /// Normal stress of the preshear that consolidated the sample before a point of failure [Pa],
    /// if known.
    std::optional<double> preshear_stress = {};

    /// Whether the grains are dry: the liquid content is 0.
    bool dry() const { return liquid_content == 0; }
    bool operator==(const Condition&) const = default;
};

/// Part of the error of a reading (measured state) that several readings have in common, such as
/// the error of one filling of the cell.
struct SharedError {
    /// Number that identifies what causes the error, such as one filling of the cell. Shared errors
    /// with equal numbers are fully correlated.
    std::size_t source = 0;
    /// Standard errors that the shared error causes in (shear stress [Pa], solid fraction [1]). The
    /// standard errors are increased if they were estimated from few fillings.
    Eigen::Vector2d size = Eigen::Vector2d::Zero();
    /// True if the size of the shared error is known; false if it was estimated from replicates
    /// (readings at the same condition).
    bool known = false;
};

/// One measured state: shear stress [Pa] and solid fraction [1] at one condition, with their
/// errors. The state is either the mean over a step of steady shear, or a point of failure.
struct Reading {
    Position origin;    ///< file, and first line in it, from which the reading was made
    int last_line = 0;  ///< last line of the file from which the reading was made; 0: `origin.line`
    /// Number of the reading's step of constant set points in its file, from 1; 0: unknown.
    int step = 0;
    Condition condition;
    /// Shear rate of the reading [1/s]; 0: only the inertial number was given.
    double shear_rate = 0;
    /// Measured values of the reading: magnitude of the shear stress [Pa], solid fraction [1].
    Eigen::Vector2d value = Eigen::Vector2d::Zero();
    /// Covariance of the errors of the reading's (shear stress [Pa], solid fraction [1]), all
    /// errors included. The part from the scatter between replicates (readings at the same
    /// condition) is increased if the replicates are few.
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
    /// Amount by which the reading's `covariance` was increased because the scatter between
    /// replicates (readings at the same condition) was estimated from few replicates.
    Eigen::Matrix2d widened_by = Eigen::Matrix2d::Zero();
    /// Errors that this reading has in common with other readings, such as the error of one filling
    /// of the cell. They are contained in `covariance`.
    std::vector<SharedError> shared;
    /// Degrees of freedom of the estimated scatter between replicates in (shear stress, solid
    /// fraction); infinite if the scatter is known.
    Eigen::Vector2d scatter_freedom = Eigen::Vector2d::Constant(INFINITY);
    /// Index in `ReplicateScatter::groups` of the group of files to which the reading's file
    /// belongs.
    std::size_t scatter_group = 0;
    /// Rounding steps of (shear stress [Pa], solid fraction [1]): unit of the last digit in the
    /// table that the reading was read from; 0 if the value was not rounded.
    Eigen::Vector2d resolution = Eigen::Vector2d::Zero();
    /// Duration of the steady shear over which the reading was averaged [s]; 0: unknown.
    double sampled_seconds = 0;
    /// True if the errors in the reading's `covariance` come only from the scatter within one run
    /// of the rheometer, not from the scatter between runs or fillings.
    bool within_run_only = false;
    /// True if the reading's error of shear stress or solid fraction is unknown; a standard error
    /// of 2 % of the value was then assumed.
    bool error_assumed = false;
    /// Number of readings of the study at the condition of this reading, including this reading.
    int replicates = 1;

    /// Covariance of (shear stress [Pa], solid fraction [1]) without the increase for few
    /// replicates. It is for statistical tests that allow for the small number of replicates in
    /// another way.
    Eigen::Matrix2d estimated_covariance() const { return covariance - widened_by; }
    /// Stress ratio of the reading [1]: shear stress divided by normal stress.
    double stress_ratio() const { return value(0) / condition.normal_stress; }
};

/// Rows of a file that were not used for a reading, with the reason.
struct Excluded {
    /// Kind of the excluded data: single rows, such as a spike (`rows`); rows of a step outside its
    /// steady part, such as a transient (`beside_plateau`); a whole step without a steady part
    /// (`step_without_plateau`); or a whole reading (`reading`).
    enum class Kind { rows, beside_plateau, step_without_plateau, reading };
    Position origin;     ///< file, and first line in it, of the rows that were left out
    int last_line = 0;   ///< last line of the rows that were left out
    std::string reason;  ///< reason why the rows or the reading were left out, for the user
    Kind kind = Kind::rows;
};

/// Statement that measured values are probably wrong, such as a solid fraction above that of the
/// densest packing, with their positions.
struct Doubt {
    /// Message for the user about the doubtful values: file, quantity, value, violated limit,
    /// likely cause.
    std::string what;
    /// Name of the quantity whose values are probably wrong, such as "solid_fraction".
    std::string quantity;
    /// Positions in the files of the readings or rows with the doubtful values.
    std::vector<Position> origins;
    /// True if the readings or rows with the doubtful values were moved to
    /// `Measurements::excluded`, so that they are not used.
    bool set_aside = true;
};

/// Scatter between replicates (readings at the same condition) in excess of the scatter within
/// their recorded steps. Variances and mean squares are relative to the squared values of (stress
/// ratio, solid fraction), so they are dimensionless.
struct ReplicateScatter {
    /// Scatter between steps that were repeated at the same condition, in a group of files with
    /// common conditions.
    struct Group {
        std::vector<std::string> files;  ///< paths of the files in the group
        /// Covariance of the relative deviations of (stress ratio, solid fraction) between repeated
        /// steps [1] at the normal stress `reference_stress`, minus the part that follows from the
        /// scatter within each step.
        Eigen::Matrix2d excess = Eigen::Matrix2d::Zero();
        /// Mean squares of the relative deviations of (stress ratio, solid fraction) between
        /// replicates [1], including the scatter within steps. Groups that share one estimate have
        /// equal mean squares.
        Eigen::Vector2d mean_square = Eigen::Vector2d::Zero();
        /// Degrees of freedom of `mean_square` for (stress ratio, solid fraction).
        Eigen::Vector2d freedom = Eigen::Vector2d::Zero();
    };
    /// Groups of files that have conditions in common; every file of the study is in one group.
    std::vector<Group> groups;
    /// Exponents [1] that describe how the scatter between repeated steps of (stress ratio, solid
    /// fraction) depends on the normal stress:
    ///     standard deviation ~ (normal stress/reference_stress)^-exponent
    Eigen::Vector2d load_exponent = Eigen::Vector2d::Zero();
    /// Standard errors of the exponents `load_exponent` [1]; 0 if they were not estimated.
    Eigen::Vector2d load_exponent_error = Eigen::Vector2d::Zero();
    /// Degrees of freedom of the correlation between the deviations of stress ratio and of solid
    /// fraction; infinite if the correlation is known.
    double correlation_freedom = INFINITY;
    /// Normal stress to which the scatter `Group::excess` refers [Pa].
    double reference_stress = 0;

    /// Error that all steps of one filling of the cell have in common, from a two-way analysis of
    /// variance (conditions, files):
    ///     variance = (between - within)/steps, increased if there are few fillings
    struct Filling {
        /// Variance of the filling error of stress ratio or solid fraction, relative to the squared
        /// value [1], increased if there are few fillings.
        double variance = 0;
        /// Mean square of the relative deviations between files (fillings) [1].
        double between = 0;
        double within = 0;  ///< mean square of the relative deviations between steps of a file [1]
        /// Degrees of freedom of the mean square `between`. 0: no two files have a condition in
        /// common; infinite: `variance` counts as known.
        double freedom_between = 0;
        double freedom_within = 0;  ///< degrees of freedom of the mean square `within`
        /// Effective number of conditions that two files (fillings) have in common.
        double steps = 1;
    };
    /// Errors of the fillings of the cell in (stress ratio, solid fraction).
    std::array<Filling, 2> filling;
    /// True if the user stated the scatter between replicates in [scatter] of study.toml.
    bool stated = false;
};

/// Readings of a study, the rows that were left out, and messages about values that are probably
/// wrong and about faults of the recordings.
struct Measurements {
    /// Readings in the order of the entries of study.toml, within an entry by file name.
    std::vector<Reading> readings;
    /// Scatter between replicates (readings at the same condition), which the covariances of the
    /// readings contain.
    ReplicateScatter scatter;
    /// Rows of files, and whole readings, that were left out, with the reasons.
    std::vector<Excluded> excluded;
    /// Messages about measured values that are probably wrong, most of which were set aside.
    std::vector<Doubt> doubts;
    /// Faults found in the rows of the recordings, such as a wobble of the lid.
    std::vector<RecordingFinding> findings;
    /// Faults of whole files, such as a header that contradicts study.toml or measured values that
    /// do not follow their set points.
    std::vector<FileFinding> file_findings;
    /// Messages for the user about the conversion of files to readings, such as a torque whose sign
    /// was flipped.
    std::vector<std::string> notes;
    /// Message for the user if the weight of the grains is neglected although it is not small; else
    /// empty.
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
