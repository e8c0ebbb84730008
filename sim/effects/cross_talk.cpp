#include "sim/catalogue/effect.h"

namespace pendular {

/// Transducers that measure torque and normal force with one elastic element show a torque under a
/// pure normal force, as does a lid that is not centred. The stress ratio is shown too high by
/// arm/R, with R = 2 (Re^3 - Ri^3)/(3 (Re^2 - Ri^2)), at all conditions.
///
/// Cross-talk the other way, from torque to normal force, has no effect of its own: as T = stress
/// ratio x R F_N, it is a gain of the normal force, up to the few per cent by which the stress
/// ratios of a study differ.
Effect cross_talk() {
    return {
        .summary = "the normal force adds to the shown torque, in proportion to the normal force",
        .equation = "T_shown = T + arm F_N",
        .parameters = {{.name = "arm",
                        .unit = "m",
                        .lower = -5e-3,
                        .upper = 5e-3,
                        .neutral = 0,
                        // Chosen: adds 0.003 to the stress ratio in a cell of 21 and 45 mm.
                        .smallest_of_interest = 1e-4,
                        .meaning = "shown torque over normal force, without a true torque"}},
        .change = ChangeInstrument{.show =
                                       [](CellState shown, const Values& v) {
                                           shown.torque += v["arm"] * shown.normal_force;
                                           return shown;
                                       },
                                   .where = ChangeInstrument::Where::transducers},
        .acts_through = {"normal_stress"},
        .directly = "the torque that the empty cell shows at rest under a known weight",
        .references = {"Figliola and Beasley, Theory and Design for Mechanical Measurements "
                       "(2019): transverse "
                       "sensitivity of force and torque transducers"}};
}

}  // namespace pendular
