#pragma once

#include <numbers>

#include "data/formula_variant.h"

namespace pendular::dem {

/// Parameters of the liquid bridges in a simulation. a is the grain diameter, s22 the imposed
/// normal stress, F0 the pull-off force.
struct Wetting {
    double reduced_pressure = 0;  ///< a^2 s22/F0 [1]
    double bridge_volume = 0;     ///< of one bridge, over a^3 [1]
    /// Formula of the bridge force: as derived, or as printed in Badetti et al. (2018).
    FormulaVariant bridge_force = FormulaVariant::derived;
};

/// Largest volume of one bridge, over a^3 [1], at which bridges stay separate (pendular range).
/// Larger bridges merge where three grains touch each other.
/// Source: Badetti et al. (2018), section 3.1.
constexpr double largest_pendular_volume = 8e-3;

/// Typical number of bridges on a grain [1], with and without contact, to convert between bridge
/// volume and liquid content before a simulation gives the true number. Simulations at a friction
/// coefficient of 0.09 and P* = 3 give 7.0 to 8.2 (docs/validation.md).
constexpr double typical_coordination = 7.5;

/// Returns the liquid content of a sample [1].
///     liquid content = 3 Z (V0/a^3)/pi
/// @param bridge_volume V0/a^3 [1]
/// @param coordination mean number Z of bridges on a grain; each counts for both of its grains
/// Source: Badetti et al. (2018), Eq. (6).
inline double liquid_content(double bridge_volume, double coordination) {
    return 3 * coordination * bridge_volume / std::numbers::pi;
}
/// Returns V0/a^3 [1] at a given liquid content, the inverse of `liquid_content`.
inline double bridge_volume(double liquid_content, double coordination) {
    return std::numbers::pi * liquid_content / (3 * coordination);
}

}  // namespace pendular::dem
