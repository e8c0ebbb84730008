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

/// Imposed conditions of a measured or simulated state, which is steady shear or a point of
/// failure.
struct Condition {
    double normal_stress = 0;           ///< normal stress s22 [Pa]
    double inertial_number = 0;         ///< inertial number I [1]; 0: quasi-static limit
    double liquid_content = 0;          ///< volume of liquid over volume of grains [1]; 0: dry
    std::optional<double> height;       ///< height of the sample [m], if known
    std::optional<double> bead_volume;  ///< solid volume of the grains in the cell [m^3], if known
    double time = 0;                    ///< time since the study's first recording began [s]
    /// Whether the state is a point of failure (peak of the shear stress) rather than steady shear.
    bool at_failure = false;
    /// Normal stress of the preshear that consolidated the sample before a point of failure [Pa],
    /// if known.
    std::optional<double> preshear_stress = {};

    /// Whether the grains are dry: the liquid content is 0.
    bool dry() const { return liquid_content == 0; }
    bool operator==(const Condition&) const = default;
};

/// Part of a reading's error that is common to several readings, such as the error of one filling
/// of the cell.
struct SharedError {
    /// Number that identifies the source of the error, such as one filling: shared errors with
    /// equal numbers are fully correlated.
    std::size_t source = 0;
    /// Standard errors of (shear stress [Pa], solid fraction [1]). If few fillings determine them,
    /// they are increased.
    Eigen::Vector2d size = Eigen::Vector2d::Zero();
    /// Whether `size` is known; false: it was estimated from replicates (readings at the same
    /// condition).
    bool known = false;
};

/// One measured state, the mean over a step of steady shear or a point of failure: shear stress
/// [Pa] and solid fraction [1] at a condition, with their errors.
struct Reading {
    Position origin;    ///< file, and first of the lines that the reading was made from
    int last_line = 0;  ///< last line that the reading was made from; 0: `origin.line`
    int step = 0;  ///< number of the step of constant set points in the file, from 1; 0: unknown
    Condition condition;
    double shear_rate = 0;  ///< shear rate [1/s]; 0: only the inertial number was given
    /// Measured values: magnitude of the shear stress [Pa], solid fraction [1].
    Eigen::Vector2d value = Eigen::Vector2d::Zero();
    /// Covariance of (shear stress [Pa], solid fraction [1]), all errors included. The part from
    /// the scatter between replicates (readings at the same condition) is increased if they are
    /// few.
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
    /// Part of `covariance` by which the scatter between replicates was increased because they are
    /// few.
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
    double sampled_seconds = 0;  ///< duration of the averaged steady part [s]; 0: unknown
    /// Whether the errors in `covariance` come only from the scatter within one run of the
    /// rheometer, not from the scatter between runs or fillings.
    bool within_run_only = false;
    /// Whether the error of shear stress or solid fraction is unknown; a standard error of 2 % of
    /// the value was then assumed.
    bool error_assumed = false;
    /// Number of readings of the study at the condition of this reading, including this reading.
    int replicates = 1;

    /// Covariance of (shear stress [Pa], solid fraction [1]) without the increase for few
    /// replicates. Statistical tests that allow for the number of replicates in another way use it.
    Eigen::Matrix2d estimated_covariance() const { return covariance - widened_by; }
    /// Stress ratio of the reading [1]: shear stress over normal stress.
    double stress_ratio() const { return value(0) / condition.normal_stress; }
};

/// Rows of a file that were not used for a reading, with the reason.
struct Excluded {
    /// Kind of rows: any rows (a spike), rows of a step beside its plateau (a transient, a part of
    /// a turn), a step that reaches no plateau, or a reading that was set aside.
    enum class Kind { rows, beside_plateau, step_without_plateau, reading };
    Position origin;     ///< file and first line of the rows
    int last_line = 0;   ///< last line of the rows
    std::string reason;  ///< why the rows were left out
    Kind kind = Kind::rows;
};

/// Statement that measured values are probably wrong, such as a solid fraction above that of the
/// densest packing, with their positions.
struct Doubt {
    /// Message for the user: file, quantity, value, violated limit, likely cause.
    std::string what;
    /// Name of the quantity whose values are probably wrong, such as "solid_fraction".
    std::string quantity;
    std::vector<Position> origins;  ///< positions of the readings or rows with these values
    /// Whether these readings or rows were moved to `Measurements::excluded`.
    bool set_aside = true;
};

/// Scatter between replicates (readings at the same condition) that the scatter within their
/// recorded steps does not explain. Variances and mean squares are relative to the squared values
/// of (stress ratio, solid fraction), so they are dimensionless.
struct ReplicateScatter {
    /// Scatter between repeated steps in a group of files that have conditions in common.
    struct Group {
        std::vector<std::string> files;  ///< paths of the files
        /// Covariance of the relative deviations of (stress ratio, solid fraction) between repeated
        /// steps [1] at the normal stress `reference_stress`. The part that the scatter within each
        /// step explains is subtracted.
        Eigen::Matrix2d excess = Eigen::Matrix2d::Zero();
        /// Mean squares of the relative deviations of (stress ratio, solid fraction) between
        /// replicates [1], including the scatter within steps. Groups that share one estimate have
        /// equal mean squares.
        Eigen::Vector2d mean_square = Eigen::Vector2d::Zero();
        Eigen::Vector2d freedom = Eigen::Vector2d::Zero();  ///< degrees of freedom of `mean_square`
    };
    std::vector<Group> groups;  ///< every file is in one group
    /// Exponents [1] that describe how the scatter between repeated steps of (stress ratio, solid
    /// fraction) depends on the normal stress:
    ///     standard deviation ~ (normal stress/reference_stress)^-exponent
    Eigen::Vector2d load_exponent = Eigen::Vector2d::Zero();
    /// Standard errors of the exponents `load_exponent` [1]; 0 if they were not estimated.
    Eigen::Vector2d load_exponent_error = Eigen::Vector2d::Zero();
    /// Degrees of freedom of the correlation between the deviations of stress ratio and of solid
    /// fraction; infinite if the correlation is known.
    double correlation_freedom = INFINITY;
    double reference_stress = 0;  ///< normal stress to which `Group::excess` refers [Pa]

    /// Error that all steps of one filling of the cell have in common, from a two-way analysis of
    /// variance (conditions, files):
    ///     variance = (between - within)/steps, increased if there are few fillings
    struct Filling {
        /// Variance of the filling error over the squared value [1], increased if there are few
        /// fillings.
        double variance = 0;
        double between = 0;  ///< mean square of the relative deviations between files [1]
        double within = 0;   ///< mean square of the relative deviations between steps of a file [1]
        /// Degrees of freedom of `between`. 0: no two files have a condition in common; infinite:
        /// `variance` counts as known.
        double freedom_between = 0;
        double freedom_within = 0;  ///< degrees of freedom of `within`
        double steps = 1;  ///< effective number of conditions that two files have in common
    };
    std::array<Filling, 2> filling;  ///< filling errors of (stress ratio, solid fraction)
    bool stated = false;             ///< whether the scatter was given in [scatter] of study.toml
};

/// Readings of a study, the rows that were left out, and messages about values that are probably
/// wrong and about faults of the recordings.
struct Measurements {
    /// Readings in the order of the entries of study.toml, within an entry by file name.
    std::vector<Reading> readings;
    /// Scatter between replicates (readings at the same condition), which the covariances of the
    /// readings contain.
    ReplicateScatter scatter;
    std::vector<Excluded> excluded;  ///< rows and readings that were left out
    std::vector<Doubt> doubts;  ///< values that are probably wrong; most of them were set aside
    /// Faults that the rows of the recordings show, such as a wobble of the lid.
    std::vector<RecordingFinding> findings;
    /// Faults of whole files, such as a header that contradicts study.toml or measured values that
    /// do not follow their set points.
    std::vector<FileFinding> file_findings;
    /// Messages for the user about the import, such as a torque whose sign was flipped.
    std::vector<std::string> notes;
    /// Message on the weight of the grains, where it is neglected and not small.
    std::optional<std::string> weight_note;
};

/// Returns the imposed condition of each reading, in the order of the readings.
inline std::vector<Condition> conditions_of(const std::vector<Reading>& readings) {
    std::vector<Condition> conditions;
    for (const auto& reading : readings) {
        conditions.push_back(reading.condition);
    }
    return conditions;
}

}  // namespace pendular
