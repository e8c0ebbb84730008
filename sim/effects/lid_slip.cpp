#include "sim/catalogue/effect.h"

namespace pendular {

/// If the lid is too smooth to take the outermost beads along, the beads lag behind the lid, and
/// the sample is sheared more slowly than the lid turns. At small inertial numbers, where stresses
/// do not depend on the rate, slip changes nothing. At large inertial numbers the stress ratio is
/// too low.
Effect lid_slip() {
    return {
        .summary =
            "grains slip along the lid, which makes the shear rate smaller than the velocity of "
            "the lid suggests",
        .equation =
            "omega_shown = omega/(1 - fraction)      omega: angular velocity of a lid that shears "
            "the grains equally fast without slip",
        .parameters = {{.name = "fraction",
                        .unit = "1",
                        .lower = 0,
                        .upper = 0.9,
                        .neutral = 0,
                        // Chosen: 5 % of the shear rate, on which stresses depend weakly.
                        .smallest_of_interest = 0.05,
                        .meaning = "velocity of the slip, divided by the velocity of the lid"}},
        .change = ChangeInstrument{.show =
                                       [](CellState shown, const Values& v) {
                                           shown.angular_velocity /= 1 - v["fraction"];
                                           return shown;
                                       },
                                   .where = ChangeInstrument::Where::grains},
        .acts_through = {"inertial_number"},
        .directly = "the velocity of the grains at the lid, seen through the wall",
        .references = {
            "GDR MiDi, Eur. Phys. J. E 14 (2004) 341: slip at the walls of dense granular flows",
            "Barnes, J. Non-Newtonian Fluid Mech. 56 (1995) 221: wall slip"}};
}

}  // namespace pendular
