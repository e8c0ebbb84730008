#pragma once

#include <cmath>
#include <numbers>

#include "data/formula_variant.h"

namespace pendular::dem {

/// Dimensionless parameters of the liquid bridges in a simulation.
struct Wetting {
    /// Reduced pressure a^2 s22/F0 [1], with grain diameter a, imposed normal stress s22 and
    /// pull-off force F0 of a bridge.
    double reduced_pressure = 0;
    /// Volume of one liquid bridge divided by the cubed grain diameter [1].
    double bridge_volume = 0;
    /// Variant of the formula of the bridge force: as derived, or as printed in Badetti et al.
    /// (2018).
    FormulaVariant bridge_force = FormulaVariant::derived;
};

/// Largest volume of one liquid bridge, divided by the cubed grain diameter [1], at which bridges
/// stay separate (pendular range). Larger bridges merge where three grains touch each other.
/// Source: Badetti et al. (2018), section 3.1.
constexpr double largest_pendular_volume = 8e-3;

/// Typical number of liquid bridges on a grain [1]: bridges to grains that touch the grain plus
/// bridges to grains that do not touch it. The number serves to convert between bridge volume and
/// liquid content before a simulation gives the true number. At a friction coefficient of 0.09, the
/// liquid contents and bridge volumes of Badetti et al. (2018) give 7 to 8 bridges on a grain.
constexpr double typical_coordination = 7.5;

/// Returns the liquid content of a sample [1]: volume of liquid divided by volume of grains.
///     liquid content = 3 Z (V0/a^3)/pi
/// @param bridge_volume volume V0 of one liquid bridge divided by the cubed grain diameter a^3 [1]
/// @param coordination mean number Z of bridges on a grain [1]; each bridge counts for both of its
///         grains
/// Source: Badetti et al. (2018), Eq. (6).
inline double liquid_content(double bridge_volume, double coordination) {
    return 3 * coordination * bridge_volume / std::numbers::pi;
}
/// Returns the volume of one liquid bridge, divided by the cubed grain diameter [1], in a sample
/// with a given liquid content. The function is the inverse of `liquid_content`.
/// @param liquid_content volume of liquid divided by volume of grains [1]
/// @param coordination mean number of bridges on a grain [1]; each bridge counts for both of its
///         grains
inline double bridge_volume(double liquid_content, double coordination) {
    return std::numbers::pi * liquid_content / (3 * coordination);
}

/// Law of the attraction F of two equal grains by a liquid bridge. Lengths are in grain diameters
/// a, forces in units of a^2 s22 with the imposed normal stress s22.
///     F = F0 [1 - 1/sqrt(1 + c/h^2)] = F0 [1 - h/sqrt(h^2 + c)],  c = 4 V0/(pi a)
/// The length h >= 0 is the gap between the grains, and V0 the volume of the bridge. The pull-off
/// force F0 = pi a Gamma cos(theta) follows from surface tension Gamma and contact angle theta. A
/// bridge forms on contact and breaks if the gap exceeds V0^(1/3).
/// Source: Maugis, J. Adhesion Sci. Technol. 1 (1987) 105, with the grain radius in c; Badetti et
/// al. (2018), Eq. (5), print half of this c (FormulaVariant::as_printed).
struct BridgeLaw {
    /// Pull-off force F0 of a bridge (its attraction in contact), divided by a^2 s22 [1], with
    /// grain diameter a and imposed normal stress s22. The pull-off force is 0 for dry grains.
    double pull_off_force = 0;
    /// Gap V0^(1/3) at which a bridge of volume V0 breaks [grain diameters].
    double rupture_distance = 0;
    /// Constant c [squared grain diameters] in the attraction F0 [1 - 1/sqrt(1 + c/h^2)] of a
    /// bridge with pull-off force F0 at gap h.
    double curvature = 1;
    double volume = 0;  ///< volume V0 of one liquid bridge [cubed grain diameters]

    BridgeLaw() = default;
    explicit BridgeLaw(const Wetting& wetting)
        : pull_off_force(1 / wetting.reduced_pressure),
          rupture_distance(std::cbrt(wetting.bridge_volume)),
          curvature((wetting.bridge_force == FormulaVariant::as_printed ? 2 : 4) *
                    wetting.bridge_volume / std::numbers::pi),
          volume(wetting.bridge_volume) {}

    bool wet() const { return pull_off_force > 0; }

    /// Returns the attraction of two grains by a bridge, divided by the pull-off force [1].
    /// @param gap gap between the grains, zero or more [grain diameters]
    double relative_force(double gap) const { return 1 - gap / std::sqrt(gap * gap + curvature); }
    /// Returns the attraction of two grains by a bridge, in units of a^2 s22, with grain diameter a
    /// and imposed normal stress s22.
    /// @param gap gap between the grains, zero or more [grain diameters]
    double attraction(double gap) const { return pull_off_force * relative_force(gap); }
    /// Returns the bridge law between two grains of unequal diameters d1 and d2, in Derjaguin's
    /// approximation. The pull-off force is proportional to d = 2 d1 d2/(d1 + d2). The constant c
    /// in the attraction is proportional to 1/d. The volume and the rupture distance of the bridge
    /// are unchanged.
    /// @param diameter the diameter d, divided by the mean grain diameter [1]
    BridgeLaw of(double diameter) const {
        BridgeLaw law = *this;
        law.pull_off_force *= diameter;
        law.curvature /= diameter;
        return law;
    }
    /// Returns the potential energy of a liquid bridge between two grains, in units of a^3 s22,
    /// with grain diameter a and imposed normal stress s22. The energy is zero at the gap at which
    /// the bridge breaks, and negative at smaller gaps.
    /// @param gap gap between the grains, zero or more [grain diameters]
    double potential(double gap) const {
        const double root = std::sqrt(gap * gap + curvature);
        const double root_at_rupture = std::sqrt(rupture_distance * rupture_distance + curvature);
        return -pull_off_force * (rupture_distance - gap - (root_at_rupture - root));
    }
    /// Returns 1 if a bridge joins two grains after a time step, else 0. A bridge always joins
    /// grains that overlap. Without overlap, a bridge persists up to the rupture distance.
    /// @param overlap overlap of the grains [grain diameters], 0 without contact
    /// @param gap gap between the grains [grain diameters], 0 in contact
    /// @param before 1 if a bridge joined the grains before the time step, else 0
    double joined(double overlap, double gap, double before) const {
        return overlap > 0 ? 1.0 : gap > rupture_distance ? 0.0 : before;
    }
};

}  // namespace pendular::dem
