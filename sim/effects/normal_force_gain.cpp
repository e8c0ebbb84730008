#include "sim/catalogue/effect.h"

namespace pendular {

/// A load cell whose calibration has drifted reads every normal force too high or too low by the
/// same factor, so that a stress ratio is shown as stress ratio/gain. A rheometer that controls the
/// force it shows presses too hard by 1/gain: inertial numbers then change by sqrt(gain), and
/// reduced pressures by 1/gain, which is what tells this gain from that of the torque.
Effect normal_force_gain() {
    return {.summary =
                "a wrong calibration of the load cell multiplies every normal force by a constant",
            .equation = "F_shown = gain F_N",
            .parameters = {{.name = "gain",
                            .unit = "1",
                            .lower = 0.5,
                            .upper = 2,
                            .neutral = 1,
                            // Chosen: 2 %, the error that readings without replicates are given.
                            .smallest_of_interest = 0.02,
                            .meaning = "shown normal force over true normal force"}},
            .change = ChangeInstrument{.show =
                                           [](CellState shown, const Values& v) {
                                               shown.normal_force *= v["gain"];
                                               return shown;
                                           },
                                       .where = ChangeInstrument::Where::transducers},
            .acts_through = {"normal_stress"},
            .directly = "calibration weights on the load cell",
            .references = {
                "Schulze, Powders and Bulk Solids (2008): calibration of ring shear testers"}};
}

}  // namespace pendular
