#include "sim/catalogue/effect.h"

namespace pendular {

/// A torque transducer whose calibration has drifted reads every torque too high or too low by the
/// same factor, so that the ratio of shown to true stress ratio is the same at all conditions.
Effect torque_gain() {
    return {
        .summary =
            "a wrong calibration of the torque transducer multiplies every torque by a constant",
        .equation = "T_shown = gain T",
        .parameters = {{.name = "gain",
                        .unit = "1",
                        .lower = 0.5,
                        .upper = 2,
                        .neutral = 1,
                        // Chosen: 2 %, the error that readings without replicates are given.
                        .smallest_of_interest = 0.02,
                        .meaning = "shown torque over true torque"}},
        .change = ChangeInstrument{.show =
                                       [](CellState shown, const Values& v) {
                                           shown.torque *= v["gain"];
                                           return shown;
                                       },
                                   .where = ChangeInstrument::Where::transducers},
        .acts_through = {"shear_stress"},
        .directly = "a known torque, such as a weight on a lever",
        .references = {
            "Schulze, Powders and Bulk Solids (2008): calibration of ring shear testers"}};
}

}  // namespace pendular
