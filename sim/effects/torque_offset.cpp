#include "sim/catalogue/effect.h"

namespace pendular {

/// The drag of bearings and seals does not depend on the sample: it is the same at every normal
/// stress and in an empty cell. Its contribution to the stress ratio resembles a cohesion, also for
/// dry beads.
Effect torque_offset() {
    return {
        .summary = "drag of bearings and seals adds a constant torque",
        .equation = "T_shown = T + torque",
        .parameters = {{.name = "torque",
                        .unit = "N m",
                        .lower = -0.1,
                        .upper = 0.1,
                        .neutral = 0,
                        // Chosen: 1 % of the torque at 0.3 kPa in a cell of 21 and 45 mm.
                        .smallest_of_interest = 1e-4,
                        .meaning = "constant torque that is added to the true torque"}},
        .change = ChangeInstrument{.show =
                                       [](CellState shown, const Values& v) {
                                           shown.torque += v["torque"];
                                           return shown;
                                       },
                                   .where = ChangeInstrument::Where::transducers},
        .acts_through = {"1/normal_stress"},
        .directly = "the torque of the empty cell while it turns",
        .references = {"Schulze, Powders and Bulk Solids (2008), section 4.3: tare of the shear "
                       "force of ring shear testers"}};
}

}  // namespace pendular
