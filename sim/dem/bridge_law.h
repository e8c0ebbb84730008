#pragma once

#include <cmath>
#include <numbers>

#include "data/formula_variant.h"

namespace pendular::dem {

/// Parameters of the liquid bridges as a user states them, dimensionless; a is the grain diameter,
/// s22 the imposed normal stress.
struct Wetting {
    double reduced_pressure = 0;  ///< P* = a^2 s22/F0, F0 being the pull-off force [1]
    double bridge_volume = 0;     ///< volume V0 of one liquid bridge over a^3 [1]
    FormulaVariant bridge_force = FormulaVariant::derived;
};

/// Largest volume V0/a^3 of one liquid bridge [1] in the pendular range, in which bridges stay
/// separate: larger bridges between three grains in contact with each other merge; a is the grain
/// diameter. Source: Badetti et al. (2018), section 3.1.
constexpr double largest_pendular_volume = 8e-3;

/// First guess of the mean number of liquid bridges of a grain [1], with and without contact. At
/// friction 0.09 this number is 7 to 8 over the pendular range, from the liquid contents and bridge
/// volumes that Badetti et al. (2018) print.
constexpr double typical_coordination = 7.5;

/// Liquid content Phi_L/Phi_S, volume of liquid over volume of grains [1], of a sample with on
/// average Z = `coordination` bridges per grain, each of the volume V0 = `bridge_volume` [a^3]:
/// 3 Z V0/(pi a^3). Source: Badetti et al. (2018), eq:lcont.
inline double liquid_content(double bridge_volume, double coordination) {
    return 3 * coordination * bridge_volume / std::numbers::pi;
}
/// Volume V0 of one liquid bridge over the cubed grain diameter [1], in a sample whose volume of
/// liquid over volume of grains is `liquid_content` [1], with on average `coordination` bridges per
/// grain.
inline double bridge_volume(double liquid_content, double coordination) {
    return std::numbers::pi * liquid_content / (3 * coordination);
}

/// Capillary attraction of two equal grains joined by a bridge, in reduced units.
///     F = F0 [1 - 1/sqrt(1 + c/h^2)] = F0 [1 - h/sqrt(h^2 + c)],  c = 4 V0/(pi a)
/// at a gap h of zero or more; F = F0 = pi a Gamma cos(theta) in contact; a: grain diameter, V0:
/// bridge volume, Gamma: surface tension, theta: contact angle. A bridge forms on contact and
/// breaks when the gap exceeds D0 = V0^(1/3). Source: Maugis, J. Adhesion Sci. Technol. 1
/// (1987) 105, with the grain radius in c; Badetti et al. (2018), eq:Maugis, print half of this c
/// (FormulaVariant::as_printed).
struct BridgeLaw {
    double pull_off_force = 0;    ///< pull-off force F0 [a^2 s22]; 0: dry
    double rupture_distance = 0;  ///< largest gap D0 that a bridge spans without breaking [a]
    double curvature = 1;         ///< constant c in the attraction F(h) at the gap h [a^2]
    double volume = 0;            ///< volume V0 of one bridge [a^3]

    BridgeLaw() = default;
    explicit BridgeLaw(const Wetting& wetting)
        : pull_off_force(1 / wetting.reduced_pressure),
          rupture_distance(std::cbrt(wetting.bridge_volume)),
          curvature((wetting.bridge_force == FormulaVariant::as_printed ? 2 : 4) *
                    wetting.bridge_volume / std::numbers::pi),
          volume(wetting.bridge_volume) {}

    bool wet() const { return pull_off_force > 0; }

    /// Capillary attraction of two grains joined by a bridge at a gap of zero or more [diameters],
    /// over the pull-off force F0 [1].
    double relative_force(double gap) const { return 1 - gap / std::sqrt(gap * gap + curvature); }
    /// Capillary attraction [a^2 s22] of two grains joined by a bridge at a gap of zero or more
    /// [diameters].
    double attraction(double gap) const { return pull_off_force * relative_force(gap); }
    /// Returns the bridge law between grains of the unequal diameters d1 and d2, given `diameter`
    /// d = 2 d1 d2/(d1 + d2) over the mean grain diameter [1], in Derjaguin's approximation: the
    /// pull-off force grows as d, the constant c as 1/d; the bridge volume stays.
    BridgeLaw of(double diameter) const {
        BridgeLaw law = *this;
        law.pull_off_force *= diameter;
        law.curvature /= diameter;
        return law;
    }
    /// Potential energy of a liquid bridge at a gap of zero or more [diameters]; zero at the gap at
    /// which it ruptures [a^3 s22].
    double potential(double gap) const {
        const double root = std::sqrt(gap * gap + curvature);
        const double root_at_rupture = std::sqrt(rupture_distance * rupture_distance + curvature);
        return -pull_off_force * (rupture_distance - gap - (root_at_rupture - root));
    }
    /// Returns 1 where a bridge joins two grains after a step, else 0: 1 at an overlap above 0, 0
    /// at a gap beyond the rupture distance (both in diameters), otherwise `before` (1 or 0), the
    /// state of the pair at the step before.
    double joined(double overlap, double gap, double before) const {
        return overlap > 0 ? 1.0 : gap > rupture_distance ? 0.0 : before;
    }
};

}  // namespace pendular::dem
