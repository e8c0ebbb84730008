#include <cmath>

#include "data/grains.h"
#include "sim/catalogue/effect.h"
#include "sim/effects/wall_mobilisation.h"

namespace pendular {
namespace {

/// s33/s22 = 1 - N2 of dry flow, 33 being normal to the side walls. N2 = 0.063 +- 0.006 in the run
/// of friction 0.09, I = 0.003 and 1000 beads of sim/atlas/atlas.csv; 0.05 to 0.08 at frictions
/// 0.05 to 0.15. Cells have 0.85 in the mean (data/sheared_layer.cpp), less in creeping beds.
constexpr double lateral_stress_ratio = 1 - 0.063;

double square(double x) {
    return x * x;
}

/// k H/w [1].
double slenderness(const CellState& cell, const Values& v) {
    return v["coefficient"] * lateral_stress_ratio * cell.height / cell.width();
}

/// (Re^2 + Ri^2)/(Re + Ri) [m].
double arm(const CellState& cell) {
    return (square(cell.outer_radius) + square(cell.inner_radius)) /
           (cell.outer_radius + cell.inner_radius);
}

double inertial_number(const CellState& cell) {
    // A search for the true state may ask for a force of no flow.
    if (!(cell.normal_force > 0)) return 0;
    const double rate = std::abs(cell.angular_velocity) * (cell.inner_radius + cell.outer_radius) /
                        (2 * cell.height);
    return pendular::inertial_number(rate, cell.normal_force / cell.area(),
                                     {.diameter = cell.diameter, .density = cell.density});
}

}  // namespace

/// Derivation. Beads press on the side walls with the normal stress s33 = lateral stress ratio x
/// s22. The friction stress of a bead that slides there is k s22 with k = coefficient x lateral
/// stress ratio. Both walls together have a perimeter of 2 pi (Ri + Re) = 2 A/w, with A the area
/// and w = Re - Ri.
///
/// Horizontal: the share m of the friction acts along the flow (`mobilised_share`), nearly all of
/// it in the upper half of the bed. A ring of height dz drags with int m k (F/A) r dA over both
/// walls = m k (F/A) 2 pi (Re^2 + Ri^2) dz, that is 2 m k (F/w) (Re^2 + Ri^2)/(Re + Ri) dz. Over
/// H/2, with F taken at mid-height, the torque on the lid exceeds the torque at mid-height by
///     M k (H/w) F (Re^2 + Ri^2)/(Re + Ri),   M the mean of m over the upper half,
/// of which M k (H/w) F (Re + Ri)/2 is the limit of a narrow annulus (12 % less at 21 and 45 mm).
///
/// Vertical: friction has one direction. Beads that slide along the flow leave the share c =
/// `carrying_share` to hold up the load (Janssen's silo at rest: 1): dF/dz = -c k (F/A) (2 A/w)
/// with the depth z under the lid. From the lid to mid-height F falls by exp(-c k H/w), so that the
/// normal force at the lid is F_mid exp(c k H/w).
///
/// The coefficient is what beads show that slide along the walls. Free beads roll on rough walls
/// before they slide: those of friction 0.12 show 0.050, 0.132 and 0.175 of walls of friction 0.05,
/// 0.15 and 0.3 (bench/real_cell). Beads that are glued to a sled cannot roll, so that its value is
/// an upper limit there.
///
/// The bed is taken to be sheared evenly, where both shares follow from its height alone. Where
/// shear gathers under the lid, `shear-localisation` holds.
Effect wall_friction() {
    return {
        .summary =
            "friction at the side walls of an evenly sheared bed raises the torque at the lid",
        .equation =
            "T_shown = T + M k (H/w) F_N (Re^2 + Ri^2)/(Re + Ri)\n"
            "F_shown = F_N exp(0.09 k H/w)\n"
            "k = coefficient x 0.94, the lateral stress ratio s33/s22 of dry flow; w = Re - "
            "Ri; F_N and T at "
            "mid-height\n"
            "coefficient: of beads that slide. Free beads roll on rough walls: of beads of "
            "friction 0.12, a wall of 0.15\n"
            "shows 0.13, one of 0.3 no more than 0.18.\n"
            "M: share of the friction that acts along the flow, mean over the upper half of the "
            "bed: 0.97 at a height\n"
            "of 12 diameters and I = 0.03, 0.82 at 6 diameters (docs/explanation/cell.md). Where "
            "the "
            "bed is not sheared\n"
            "evenly, use shear-localisation.",
        .parameters = {{.name = "coefficient",
                        .unit = "1",
                        .lower = 0,
                        .upper = 1,
                        .neutral = 0,
                        // Chosen: in a filling as high as the cell is wide it raises a stress
                        // ratio of 0.3 by a sixth.
                        .smallest_of_interest = 0.05,
                        .meaning = "friction coefficient between grains and side walls"}},
        .change =
            ChangeInstrument{.show =
                                 [](CellState shown, const Values& v) {
                                     const double thin = slenderness(shown, v);
                                     const double along = mobilised_in_upper_half(
                                         shown.height / shown.diameter, inertial_number(shown));
                                     shown.torque += along * thin * shown.normal_force * arm(shown);
                                     shown.normal_force *= std::exp(carrying_share * thin);
                                     return shown;
                                 },
                             .where = ChangeInstrument::Where::grains},
        .acts_through = {"height"},
        .directly = "a sled with grains glued to it, pulled over the material of the walls",
        .references = {
            "Janssen, Z. Ver. dt. Ing. 39 (1895) 1045: silo pressure",
            "Artoni and Richard, Phys. Rev. Lett. 115 (2015) 158001: effective wall friction",
            "Schulze, Powders and Bulk Solids (2008): wall friction in ring shear testers"}};
}

}  // namespace pendular
