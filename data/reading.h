#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "data/grains.h"
#include "data/input_error.h"

namespace pendular {

/// Imposed conditions of one measured or simulated state of steady shear.
struct Condition {
    double normal_stress = 0;           ///< s22 [Pa]
    double inertial_number = 0;         ///< I [1]; 0: the quasi-static limit
    double liquid_content = 0;          ///< Phi_L/Phi_S [1]; 0: dry
    std::optional<double> height;       ///< height of the sample [m], if known
    std::optional<double> bead_volume;  ///< volume of the beads in the cell [m^3], if known
    double time = 0;                    ///< time since the first recording began [s]

    bool dry() const { return liquid_content == 0; }
    bool operator==(const Condition&) const = default;
};

/// Error that several readings share, such as the error of one filling of the cell.
struct SharedError {
    std::size_t source =
        0;  ///< readings with the same number have the same error, fully correlated
    Eigen::Vector2d size = Eigen::Vector2d::Zero();  ///< standard error in `value` of a reading
    Eigen::Vector2d estimated =
        Eigen::Vector2d::Zero();  ///< standard error before widening for few replicates
    bool known = false;           ///< the size is stated, not estimated from replicates
};

/// One measured steady state: (shear stress [Pa], solid fraction [1]) at a condition.
struct Reading {
    Position origin;    ///< file and first line of the rows of this reading
    int last_line = 0;  ///< last line of its rows; 0: the first line
    int step = 0;       ///< step of constant set points within the file, from 1
    Condition condition;
    double shear_rate = 0;  ///< shear rate [1/s]; 0: the inertial number was given instead
    Eigen::Vector2d value =
        Eigen::Vector2d::Zero();  ///< shear stress magnitude [Pa], solid fraction [1]
    /// Covariance of `value` with all errors; the scatter is widened where few replicates determine
    /// it.
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
    /// Part of `covariance` that the widening added.
    Eigen::Matrix2d widened_by = Eigen::Matrix2d::Zero();
    std::vector<SharedError> shared;  ///< parts of `covariance` that are shared with other readings
    /// Degrees of freedom that the scatter of each observable was estimated with.
    Eigen::Vector2d scatter_freedom = Eigen::Vector2d::Constant(INFINITY);
    std::size_t scatter_group = 0;  ///< place in ReplicateScatter::groups
    /// Step to which `value` was rounded where it was written down; 0: none worth mention.
    Eigen::Vector2d resolution = Eigen::Vector2d::Zero();
    double sampled_seconds = 0;    ///< length of the steady part [s]; 0 for ready-made readings
    bool within_run_only = false;  ///< `covariance` as read knows nothing of other runs or fillings
    bool error_assumed = false;    ///< 2 % of a value was assumed, nothing was measured
    int replicates = 1;  ///< readings of the same liquid content and set points, this one included

    /// Covariance of `value` with the scatter as estimated, for tests that allow for the number of
    /// replicates themselves.
    Eigen::Matrix2d estimated_covariance() const { return covariance - widened_by; }
    double stress_ratio() const { return value(0) / condition.normal_stress; }
};

/// A row or step that was not used, and why.
struct Excluded {
    Position origin;
    int last_line = 0;  ///< of the rows left out
    std::string reason;
};

/// A measured value, or several, that cannot be right.
struct Doubt {
    /// One sentence: file, quantity, value, the limit it breaks, the likely cause.
    std::string what;
    std::string quantity;           ///< name of what is doubted, "solid_fraction" for example
    std::vector<Position> origins;  ///< of the readings or rows concerned
    bool set_aside = true;          ///< whether they were moved to `excluded`
};

/// Scatter between replicates in excess of the scatter within them, relative to the values of
/// (stress ratio, solid fraction) [1].
struct ReplicateScatter {
    /// Scatter from step to step in files that replicate each other.
    struct Group {
        std::vector<std::string> files;
        Eigen::Matrix2d excess = Eigen::Matrix2d::Zero();  ///< variance at `reference_stress`
        /// Mean square between replicates, that within runs included; the same number for groups
        /// that share one estimate.
        Eigen::Vector2d mean_square = Eigen::Vector2d::Zero();
        Eigen::Vector2d freedom = Eigen::Vector2d::Zero();  ///< degrees of freedom it rests on
    };
    std::vector<Group> groups;
    /// Standard deviation of step scatter ~ (normal stress/reference)^-exponent, by observable [1].
    Eigen::Vector2d load_exponent = Eigen::Vector2d::Zero();
    /// Standard errors of `load_exponent` [1]; 0 where it is not estimated.
    Eigen::Vector2d load_exponent_error = Eigen::Vector2d::Zero();
    /// Degrees of freedom that the correlation between the observables rests on; infinite: known.
    double correlation_freedom = INFINITY;
    double reference_stress = 0;  ///< [Pa]

    /// Errors that all steps of one filling share. From the mean squares of a two-way analysis of
    /// variance (conditions, files): (between - within)/steps, widened.
    struct Filling {
        double variance = 0;         ///< relative, widened for how few fillings tell it [1]
        double between = 0;          ///< mean square between files, relative [1]
        double within = 0;           ///< mean square between steps, relative [1]
        double freedom_between = 0;  ///< 0: no two files share a condition
        double freedom_within = 0;
        double steps = 1;  ///< effective number of conditions that two files share
    };
    std::array<Filling, 2> filling;  ///< of stress ratio, of solid fraction
    bool stated = false;             ///< it is that of `[scatter]` in the study
};

/// All readings of a study, with every excluded row and its reason.
struct Measurements {
    std::vector<Reading> readings;  ///< in run order
    ReplicateScatter scatter;       ///< that is in the covariances of the readings
    std::vector<Excluded> excluded;
    std::vector<Doubt> doubts;       ///< about what the files say; most were set aside
    std::vector<std::string> notes;  ///< checks worth a line: a flipped torque, heavy beads
};

/// Condition of each reading, in the order of `readings`.
inline std::vector<Condition> conditions_of(const std::vector<Reading>& readings) {
    std::vector<Condition> conditions;
    for (const auto& reading : readings) {
        conditions.push_back(reading.condition);
    }
    return conditions;
}

}  // namespace pendular
