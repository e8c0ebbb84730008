#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "data/grains.h"
#include "data/input_error.h"

namespace pendular {

/// Values of the parameters of an effect.
struct EffectValues {
    std::string effect;
    std::vector<double> values;  ///< in the order of its parameters

    bool operator==(const EffectValues&) const = default;
};

/// What is imposed on a sample: one measured or simulated state of steady shear.
struct Condition {
    double normal_stress = 0;           ///< s22 [Pa]
    double inertial_number = 0;         ///< I [1]; 0: the quasi-static limit
    double liquid_content = 0;          ///< Phi_L/Phi_S [1]; 0: dry
    std::optional<double> height;       ///< of the cell [m], where known
    std::optional<double> bead_volume;  ///< in the cell [m^3], where known
    double time = 0;                    ///< since the first recording began [s]

    // What effects make of the study's beads and liquid here.
    std::optional<Liquid> liquid;             ///< none: the study's
    double friction_difference = 0;           ///< to the friction of the study
    std::vector<EffectValues> grain_effects;  ///< on grains, in SI units

    bool dry() const { return liquid_content == 0; }
    bool operator==(const Condition&) const = default;
};

/// One measured steady state: (shear stress [Pa], solid fraction [1]) at a condition.
struct Reading {
    Position origin;  ///< file and first line it was made from
    int step = 0;     ///< step of constant set points within the file, from 1
    Condition condition;
    double shear_rate = 0;  ///< [1/s]; 0 where the inertial number was given instead
    Eigen::Vector2d value =
        Eigen::Vector2d::Zero();  ///< shear stress magnitude [Pa], solid fraction [1]
    Eigen::Matrix2d covariance =
        Eigen::Matrix2d::Zero();  ///< of `value`, within run plus between replicates
    double sampled_seconds = 0;   ///< length of the steady part [s]; 0 for ready-made readings
    bool error_assumed = false;   ///< 2 % of each value was assumed, nothing was measured
    int replicates = 1;  ///< readings of the same liquid content and set points, this one included

    double stress_ratio() const { return value(0) / condition.normal_stress; }
};

/// A row or step that was not used, and why.
struct Excluded {
    Position origin;
    int last_line = 0;  ///< of the rows left out
    std::string reason;
};

/// Scatter between replicates beyond that within them, pooled over all conditions.
struct ReplicateScatter {
    /// Relative to the values of (stress ratio, solid fraction) [1]; widened as below.
    Eigen::Matrix2d excess = Eigen::Matrix2d::Zero();
    double freedom = 0;   ///< degrees of freedom it was estimated with
    double widening = 1;  ///< factor on the standard errors that is in `excess`
};

/// Everything that was measured in a study, with nothing dropped in silence.
struct Measurements {
    std::vector<Reading> readings;  ///< in run order
    ReplicateScatter scatter;       ///< that is in the covariances of the readings
    std::vector<Excluded> excluded;
    std::vector<std::string> notes;  ///< checks worth a line: a flipped torque, heavy beads
};

}  // namespace pendular
