#include <cmath>

#include "data/sheared_layer.h"
#include "sim/catalogue/effect.h"

namespace pendular {
namespace {

/// Bed that is sheared evenly at a state of the cell, between walls of a friction.
WalledBed evenly_sheared_bed(const CellState& cell, double wall_friction) {
    constexpr double pi = 3.14159265358979323846;
    const double normal_stress = cell.normal_force / cell.area();
    const double rate = std::abs(cell.angular_velocity) * (cell.inner_radius + cell.outer_radius) /
                        (2 * cell.height);
    // I = rate sqrt(m/(a s22)) with m = pi/6 density a^3
    const double inertial_number =
        rate * cell.diameter * std::sqrt(pi / 6 * cell.density / normal_stress);
    return {.height = cell.height / cell.diameter,
            .width = cell.width() / cell.diameter,
            .wall_friction = wall_friction,
            .inertial_number = inertial_number,
            .stress_ratio = cell.torque / cell.torque_of(normal_stress)};
}

}  // namespace

/// Side walls drag on the grains that move, so that the shear stress falls with the depth under the
/// lid. Below a layer whose height `sheared_layer` computes, grains creep or rest. The lid shears
/// this layer faster than the height of the bed suggests, and carries the drag of the walls on it:
/// the torque rises, more so for a higher bed, up to beds that are twice as high as the layer, and
/// for a faster lid. An evenly sheared bed under the same walls shows `wall-friction`, which grows
/// with the height without limit. The walls carry hardly any load, since grains slide along the
/// flow there. The solid fraction is not changed: where the resting part of a bed differs, its gap
/// creeps, and import does not use the fraction.
Effect shear_localisation() {
    return {
        .summary = "side walls gather the shear in a layer under the lid, which raises the torque",
        .equation =
            "T_shown = T mu(0)/mu\n"
            "mu = stress ratio of the grains in even shear; mu(0) = stress ratio at the lid "
            "with which the lid has its\n"
            "speed if the shear stress falls by 2 k sigma/w with the depth, k = 0.85 x "
            "coefficient, w = Re - Ri\n"
            "(docs/explanation/cell.md). A diagnosis tries it only where wall_friction is "
            "stated in [cell] or the\n"
            "gap creeps.",
        .parameters = {{.name = "coefficient",
                        .unit = "1",
                        .lower = 0,
                        .upper = 0.6,
                        .neutral = 0,
                        // Chosen: as of wall-friction.
                        .smallest_of_interest = 0.05,
                        .meaning = "friction stress over normal stress at the walls of the "
                                   "sheared layer"}},
        .change = ChangeInstrument{.show =
                                       [](CellState shown, const Values& v) {
                                           const double coefficient = v["coefficient"];
                                           // A search for the true state may ask for a torque of no
                                           // flow.
                                           if (coefficient == 0 || !(shown.torque > 0))
                                               return shown;
                                           const WalledBed bed =
                                               evenly_sheared_bed(shown, coefficient);
                                           shown.torque *=
                                               sheared_layer(bed).stress_ratio / bed.stress_ratio;
                                           return shown;
                                       },
                                   .where = ChangeInstrument::Where::grains},
        .of_uneven_shear = true,
        .acts_through = {"height", "inertial_number"},
        .directly = "a sled with grains glued to it, pulled over the material of the walls",
        .references = {
            "Janssen, Z. Ver. dt. Ing. 39 (1895) 1045: friction at the walls of silos",
            "Kamrin and Koval, Phys. Rev. Lett. 108 (2012) 178301: nonlocal fluidity",
            "Artoni and Richard, Phys. Rev. Lett. 115 (2015) 158001: effective wall friction",
            "Richard, Artoni, Valance and Delannay, Granular Matter 22 (2020) 81: lateral "
            "confinement"}};
}

}  // namespace pendular
