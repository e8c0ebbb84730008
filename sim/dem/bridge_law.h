#pragma once

#include <cmath>
#include <numbers>

#include "data/formula_variant.h"

namespace pendular::dem {

/// Parameters of the liquid bridges as a user states them, in reduced units.
struct Wetting {
    double reduced_pressure = 0;  ///< reduced pressure P* = a^2 s22/F0 [1]
    double bridge_volume = 0;     ///< volume of one bridge, V0/a^3 [1]
    FormulaVariant bridge_force = FormulaVariant::derived;
};

/// Largest bridge volume V0/a^3 [1] of the pendular range: larger bridges between three grains in
/// contact with each other merge. Source: Badetti et al. (2018), section 3.1.
constexpr double largest_pendular_volume = 8e-3;

/// First guess of the mean number of bridges of a grain, with and without contact [1]. At friction
/// 0.09 it is 7 to 8 over the pendular range, from the liquid contents and bridge volumes that
/// Badetti et al. (2018) print.
constexpr double typical_coordination = 7.5;

/// Liquid content Phi_L/Phi_S [1] of a sample whose grains have on average `coordination` bridges
/// of volume V0/a^3: 3 Z V0/(pi a^3). Source: Badetti et al. (2018), eq:lcont.
inline double liquid_content(double bridge_volume, double coordination) {
    return 3 * coordination * bridge_volume / std::numbers::pi;
}
/// Bridge volume V0/a^3 [1] of a sample with this liquid content Phi_L/Phi_S [1] and on average
/// `coordination` bridges per grain; the inverse of `liquid_content`.
inline double bridge_volume(double liquid_content, double coordination) {
    return std::numbers::pi * liquid_content / (3 * coordination);
}

/// Capillary attraction of two equal grains joined by a bridge, in reduced units.
///     F = F0 [1 - 1/sqrt(1 + c/h^2)] = F0 [1 - h/sqrt(h^2 + c)],  c = 4 V0/(pi a)
/// at a gap h of zero or more; F = F0 = pi a Gamma cos(theta) in contact. A bridge forms on contact
/// and breaks when the gap exceeds D0 = V0^(1/3). Source: Maugis, J. Adhesion Sci. Technol. 1
/// (1987) 105, with the grain radius in c; Badetti et al. (2018), eq:Maugis, print half of this c
/// (FormulaVariant::as_printed).
struct BridgeLaw {
    double pull_off_force = 0;    ///< pull-off force F0 [a^2 s22]; 0: dry
    double rupture_distance = 0;  ///< rupture distance D0 [a]
    double curvature = 1;         ///< curvature c of the force law [a^2]
    double volume = 0;            ///< bridge volume V0 [a^3]

    BridgeLaw() = default;
    explicit BridgeLaw(const Wetting& wetting)
        : pull_off_force(1 / wetting.reduced_pressure),
          rupture_distance(std::cbrt(wetting.bridge_volume)),
          curvature((wetting.bridge_force == FormulaVariant::as_printed ? 2 : 4) *
                    wetting.bridge_volume / std::numbers::pi),
          volume(wetting.bridge_volume) {}

    bool wet() const { return pull_off_force > 0; }

    /// Attraction at a gap of zero or more, over F0 [1].
    double relative_force(double gap) const { return 1 - gap / std::sqrt(gap * gap + curvature); }
    /// Attraction at a gap of zero or more [a^2 s22].
    double attraction(double gap) const { return pull_off_force * relative_force(gap); }
    /// Bridge law between unequal grains, given their mean diameter d = 2 d1 d2/(d1 + d2), in
    /// Derjaguin's approximation: F0 = pi d Gamma cos(theta), c = 4 V0/(pi d), with an unchanged
    /// bridge volume.
    BridgeLaw of(double diameter) const {
        BridgeLaw law = *this;
        law.pull_off_force *= diameter;
        law.curvature /= diameter;
        return law;
    }
    /// Potential energy of a bridge at a gap of zero or more, zero at rupture [a^3 s22].
    double potential(double gap) const {
        const double root = std::sqrt(gap * gap + curvature);
        const double root_at_rupture = std::sqrt(rupture_distance * rupture_distance + curvature);
        return -pull_off_force * (rupture_distance - gap - (root_at_rupture - root));
    }
    /// Returns 1 where a bridge joins two grains, else 0. A bridge forms on contact and breaks
    /// beyond the rupture distance; otherwise `before` (1 or 0), its state at the step before, is
    /// returned.
    double joined(double overlap, double gap, double before) const {
        return overlap > 0 ? 1.0 : gap > rupture_distance ? 0.0 : before;
    }
};

}  // namespace pendular::dem
