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

/// Imposed conditions of a measured or simulated state of steady shear.
struct Condition {
    double normal_stress = 0;           ///< normal stress s22 [Pa]
    double inertial_number = 0;         ///< inertial number I [1]; 0: quasi-static limit
    double liquid_content = 0;          ///< volume of liquid over volume of grains [1]; 0: dry
    std::optional<double> height;       ///< height of the sample [m], if known
    std::optional<double> bead_volume;  ///< solid volume of the grains in the cell [m^3], if known
    double time = 0;                    ///< time since the study's first recording began [s]
    /// Whether the state is a point of failure, a peak of the shear stress, rather than steady
    /// shear.
    bool at_failure = false;
    /// Normal stress of the preshear that consolidated the sample before a point of failure [Pa],
    /// if known.
    std::optional<double> preshear_stress = {};

    /// Whether the grains are dry: the liquid content is 0.
    bool dry() const { return liquid_content == 0; }
    bool operator==(const Condition&) const = default;
};

/// Part of a reading's error that other readings share, such as the error of one filling of the
/// cell. Vectors hold standard errors of (shear stress [Pa], solid fraction [1]).
struct SharedError {
    /// Number of the error's source: errors with the same number are fully correlated.
    std::size_t source = 0;
    /// Standard errors of (shear stress [Pa], solid fraction [1]), widened where few fillings
    /// determine them.
    Eigen::Vector2d size = Eigen::Vector2d::Zero();
    bool known = false;  ///< whether `size` is known, rather than estimated from replicates
};

/// One measured steady state: (shear stress [Pa], solid fraction [1]) at a condition.
struct Reading {
    Position origin;    ///< file, and first of the lines that the reading was made from
    int last_line = 0;  ///< last line that the reading was made from; 0: `origin.line`
    int step = 0;  ///< number of the step of constant set points in the file, from 1; 0: unknown
    Condition condition;
    double shear_rate = 0;  ///< shear rate [1/s]; 0: only the inertial number was given
    /// Magnitude of the shear stress [Pa], solid fraction [1].
    Eigen::Vector2d value = Eigen::Vector2d::Zero();
    /// Covariance of `value` (shear stress [Pa], solid fraction [1]), all errors included. The
    /// scatter between replicates is widened where few replicates determine it.
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
    /// Part of `covariance` that the widening for few replicates added.
    Eigen::Matrix2d widened_by = Eigen::Matrix2d::Zero();
    /// Errors, contained in `covariance`, that are shared with other readings, such as the error of
    /// one filling of the cell.
    std::vector<SharedError> shared;
    /// Degrees of freedom of the estimated scatter between replicates of (shear stress, solid
    /// fraction); infinite: the scatter is known.
    Eigen::Vector2d scatter_freedom = Eigen::Vector2d::Constant(INFINITY);
    std::size_t scatter_group = 0;  ///< index of the file's group in ReplicateScatter::groups
    /// Rounding steps of (shear stress [Pa], solid fraction [1]): unit of the last digit that the
    /// table of readings gives; 0: not rounded.
    Eigen::Vector2d resolution = Eigen::Vector2d::Zero();
    double sampled_seconds = 0;  ///< duration of the averaged steady part [s]; 0: unknown
    /// Whether the imported `covariance` contains only the scatter within a run, not the scatter
    /// between runs or fillings.
    bool within_run_only = false;
    /// Whether the error of shear stress or solid fraction is unknown, so that a standard error of
    /// 2 % of the value was added.
    bool error_assumed = false;
    /// Number of readings of the study at this reading's condition, including this reading.
    int replicates = 1;

    /// Covariance of (shear stress [Pa], solid fraction [1]) without the widening for few
    /// replicates, for statistical tests that allow for the number of replicates in another way.
    Eigen::Matrix2d estimated_covariance() const { return covariance - widened_by; }
    /// Shear stress over normal stress [1].
    double stress_ratio() const { return value(0) / condition.normal_stress; }
};

/// Rows of a file that make no reading, with the reason.
struct Excluded {
    /// Kind of rows: any rows (a spike), rows of a step beside its plateau (a transient, a part of
    /// a turn), a step that reaches no plateau, or a reading that was set aside.
    enum class Kind { rows, beside_plateau, step_without_plateau, reading };
    Position origin;     ///< file and first line of the rows
    int last_line = 0;   ///< last line of the rows
    std::string reason;  ///< why the rows were left out
    Kind kind = Kind::rows;
};

/// A reason not to believe one or more measured values.
struct Doubt {
    /// Sentence for the user: file, quantity, value, violated limit, likely cause.
    std::string what;
    std::string quantity;           ///< name of the doubtful quantity, such as "solid_fraction"
    std::vector<Position> origins;  ///< positions of the doubtful readings or rows
    /// Whether the doubtful readings or rows were moved to `Measurements::excluded`.
    bool set_aside = true;
};

/// Scatter between replicates (readings at the same condition) in excess of the scatter within the
/// recorded steps that the readings average. Variances and mean squares are relative to the squared
/// values of (stress ratio, solid fraction) [1].
struct ReplicateScatter {
    /// Scatter from step to step in a group of files that have conditions in common.
    struct Group {
        std::vector<std::string> files;  ///< paths of the files
        /// Covariance of relative deviations of (stress ratio, solid fraction) [1] from step to
        /// step, minus the part that the scatter within a step explains, at `reference_stress`.
        Eigen::Matrix2d excess = Eigen::Matrix2d::Zero();
        /// Mean squares of the deviations between replicates, relative to squared (stress ratio,
        /// solid fraction) [1], scatter within steps included; equal for groups that share one
        /// estimate.
        Eigen::Vector2d mean_square = Eigen::Vector2d::Zero();
        Eigen::Vector2d freedom = Eigen::Vector2d::Zero();  ///< degrees of freedom of `mean_square`
    };
    std::vector<Group> groups;  ///< every file is in one group
    /// Exponents [1] of the scatter from step to step of (stress ratio, solid fraction):
    ///     standard deviation ~ (normal stress/reference_stress)^-exponent.
    Eigen::Vector2d load_exponent = Eigen::Vector2d::Zero();
    /// Standard errors of `load_exponent` [1]; 0: not estimated.
    Eigen::Vector2d load_exponent_error = Eigen::Vector2d::Zero();
    /// Degrees of freedom of the correlation between the deviations of stress ratio and of solid
    /// fraction; infinite: known.
    double correlation_freedom = INFINITY;
    double reference_stress = 0;  ///< normal stress at which `Group::excess` holds [Pa]

    /// Error that all steps of one filling of the cell share, estimated by a two-way analysis of
    /// variance (conditions, files): variance = (between - within)/steps, widened for few fillings.
    struct Filling {
        double variance = 0;  ///< variance over squared value, widened for few fillings [1]
        double between = 0;   ///< mean square between files, relative [1]
        double within = 0;    ///< mean square between steps of a file, relative [1]
        /// Degrees of freedom of `between`; 0: no two files share a condition; infinite: `variance`
        /// is treated as known.
        double freedom_between = 0;
        double freedom_within = 0;  ///< degrees of freedom of `within`
        double steps = 1;           ///< effective number of conditions that two files share
    };
    std::array<Filling, 2> filling;  ///< error of stress ratio, error of solid fraction
    bool stated = false;             ///< whether the scatter was given in [scatter] of study.toml
};

/// Readings of a study, with everything that was left out or is doubtful.
struct Measurements {
    std::vector<Reading> readings;   ///< in the order of study.toml, the files of an entry by name
    ReplicateScatter scatter;        ///< scatter that the readings' covariances contain
    std::vector<Excluded> excluded;  ///< rows that make no reading
    std::vector<Doubt> doubts;       ///< doubts about the files' values; most values were set aside
    /// Findings in the rows of the recordings, apart from the steady means, such as a wobble of the
    /// lid.
    std::vector<RecordingFinding> findings;
    /// Findings on whole files: headers against study.toml, measured values against set points.
    std::vector<FileFinding> file_findings;
    /// Messages for the user about the import, such as a torque whose sign was flipped.
    std::vector<std::string> notes;
    /// Message on the weight of the grains, where it is neglected and not small.
    std::optional<std::string> weight_note;
};

/// Imposed condition of each reading, in the order of `readings`.
inline std::vector<Condition> conditions_of(const std::vector<Reading>& readings) {
    std::vector<Condition> conditions;
    for (const auto& reading : readings) {
        conditions.push_back(reading.condition);
    }
    return conditions;
}

}  // namespace pendular
