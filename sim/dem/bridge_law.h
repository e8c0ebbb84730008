#pragma once

#include <cmath>
#include <numbers>

#include "sim/dem/wetting.h"

namespace pendular::dem {

/// Law of the attraction F of two equal grains by a liquid bridge. Lengths are in grain diameters
/// a, forces in units of a^2 s22, energies in a^3 s22, with the imposed normal stress s22.
///     F = F0 [1 - 1/sqrt(1 + c/h^2)] = F0 [1 - h/sqrt(h^2 + c)],  c = 4 V0/(pi a)
/// h >= 0 is the gap between the grains, and V0 the volume of the bridge. The pull-off force F0 =
/// pi a Gamma cos(theta) follows from surface tension Gamma and contact angle theta. A bridge forms
/// on contact and breaks if the gap exceeds V0^(1/3).
/// Source: Maugis, J. Adhesion Sci. Technol. 1 (1987) 105, with the grain radius in c; Badetti et
/// al. (2018), Eq. (5), print half of this c (FormulaVariant::as_printed).
struct BridgeLaw {
    double pull_off_force = 0;    ///< F0; 0 for dry grains
    double rupture_distance = 0;  ///< V0^(1/3)
    double curvature = 1;         ///< c
    double volume = 0;            ///< V0

    BridgeLaw() = default;
    explicit BridgeLaw(const Wetting& wetting)
        : pull_off_force(1 / wetting.reduced_pressure),
          rupture_distance(std::cbrt(wetting.bridge_volume)),
          curvature((wetting.bridge_force == FormulaVariant::as_printed ? 2 : 4) *
                    wetting.bridge_volume / std::numbers::pi),
          volume(wetting.bridge_volume) {}

    bool wet() const { return pull_off_force > 0; }

    /// Returns F/F0 [1].
    double relative_force(double gap) const { return 1 - gap / std::sqrt(gap * gap + curvature); }
    /// Returns F, in units of a^2 s22.
    double attraction(double gap) const { return pull_off_force * relative_force(gap); }
    /// Returns the law between two grains of unequal diameters d1 and d2, in Derjaguin's
    /// approximation: F0 is proportional to d = 2 d1 d2/(d1 + d2), c to 1/d. Volume and rupture
    /// distance are unchanged.
    /// @param diameter d over the mean grain diameter [1]
    BridgeLaw of(double diameter) const {
        BridgeLaw law = *this;
        law.pull_off_force *= diameter;
        law.curvature /= diameter;
        return law;
    }
    /// Returns the potential energy of a bridge, in units of a^3 s22; zero at the gap at which the
    /// bridge breaks, and negative below. At gap 0 it is -F0 [D0 + sqrt(c) - sqrt(D0^2 + c)] with
    /// the rupture distance D0: the energy that is lost where a bridge forms on contact.
    double potential(double gap) const {
        const double root = std::sqrt(gap * gap + curvature);
        const double root_at_rupture = std::sqrt(rupture_distance * rupture_distance + curvature);
        return -pull_off_force * (rupture_distance - gap - (root_at_rupture - root));
    }
    /// Returns 1 if a bridge joins two grains after a time step, else 0. A bridge always joins
    /// grains that overlap; without overlap, it persists up to the rupture distance.
    /// @param gap 0 in contact, as is `overlap` without contact
    /// @param before 1 if a bridge joined the grains before the time step, else 0
    double joined(double overlap, double gap, double before) const {
        return overlap > 0 ? 1.0 : gap > rupture_distance ? 0.0 : before;
    }
};

}  // namespace pendular::dem
