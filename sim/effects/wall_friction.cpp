#include "sim/catalogue/effect.h"

#include <cmath>

namespace pendular {
namespace {

/// s33/s22 = 1 - N2 of dry flow, 33 being normal to the side walls. N2 = 0.063 +- 0.006 in the run
/// of friction 0.09, I = 0.003 and 1000 beads of sim/atlas/atlas.csv; 0.05 to 0.08 at frictions
/// 0.05 to 0.15.
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

}  // namespace

/// Derivation. Beads press on the side walls with the normal stress s33 = lateral stress ratio x
/// s22. The friction stress at the walls is k s22 with k = coefficient x lateral stress ratio. Both
/// walls together have a perimeter of 2 pi (Ri + Re) = 2 A/w, with A the area and w = Re - Ri.
///
/// Vertical: walls hold up part of the load (Janssen), dF/dz = -k (F/A) (2 A/w) = -2 k F/w with the
/// depth z under the lid. From the lid to mid-height F falls by exp(-k H/w), so that the normal
/// force at the lid is F_mid exp(k H/w).
///
/// Horizontal: a ring of height dz drags with int k (F/A) r dA over both walls = k (F/A) 2 pi (Re^2
/// + Ri^2) dz, that is 2 k (F/w) (Re^2 + Ri^2)/(Re + Ri) dz. Over H/2, with F taken at mid-height,
/// the torque on the lid exceeds the torque at mid-height by
///     k (H/w) F (Re^2 + Ri^2)/(Re + Ri)
/// of which k (H/w) F (Re + Ri)/2 is the limit of a narrow annulus (12 % less at 21 and 45 mm).
/// The increase of F towards the lid changes this only in second order in k H/w.
///
/// Friction cannot be fully mobilised in both directions at once. The coefficient is the mobilised
/// part, assumed equal in both directions.
Effect wall_friction() {
    return {
        .summary = "friction at the side walls raises the torque and the normal force at the lid",
        .equation =
            "F_shown = F_N exp(k H/w)\n"
            "T_shown = T + k (H/w) F_N (Re^2 + Ri^2)/(Re + Ri)\n"
            "k = coefficient x 0.94, the lateral stress ratio s33/s22 of dry flow; w = Re - "
            "Ri; F_N and T at "
            "mid-height",
        .parameters = {{.name = "coefficient",
                        .unit = "1",
                        .lower = 0,
                        .upper = 1,
                        .neutral = 0,
                        // Chosen: holds up 5 % of the load in a filling as high as the gap.
                        .smallest_of_interest = 0.05,
                        .meaning = "friction coefficient between grains and side walls"}},
        .change = ChangeInstrument{.show =
                                       [](CellState shown, const Values& v) {
                                           const double thin = slenderness(shown, v);
                                           shown.torque += thin * shown.normal_force * arm(shown);
                                           shown.normal_force *= std::exp(thin);
                                           return shown;
                                       },
                                   .where = ChangeInstrument::Where::grains},
        .acts_through = {"height"},
        .directly = "a sled with grains glued to it, pulled over the material of the walls",
        .references = {
            "Janssen, Z. Ver. dt. Ing. 39 (1895) 1045: silo pressure",
            "Schulze, Powders and Bulk Solids (2008): wall friction in ring shear testers"}};
}

}  // namespace pendular
