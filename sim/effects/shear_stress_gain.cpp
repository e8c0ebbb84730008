#include "sim/catalogue/effect.h"

namespace pendular {

/// A table of readings has all shear stresses too high or too low by the same factor: a transducer
/// whose calibration has drifted, a wrong radius, or a wrong formula from torque to stress.
Effect shear_stress_gain() {
    return {
        .summary =
            "a wrong calibration or a wrong radius multiplies every shear stress of a table by a "
            "constant",
        .equation = "s12_shown = gain s12",
        .parameters = {{.name = "gain",
                        .unit = "1",
                        .lower = 0.5,
                        .upper = 2,
                        .neutral = 1,
                        // Chosen: 2 %, the error that readings without replicates are given.
                        .smallest_of_interest = 0.02,
                        .meaning = "shown shear stress over true shear stress"}},
        .change = ChangeInstrument{.show =
                                       [](CellState shown, const Values& v) {
                                           shown.torque *= v["gain"];
                                           return shown;
                                       },
                                   .where = ChangeInstrument::Where::table},
        .acts_through = {"shear_stress"},
        .directly = "a known torque on the instrument, and the radii in the formula of the stress",
        .references = {
            "Schulze, Powders and Bulk Solids (2008): calibration of ring shear testers"}};
}

}  // namespace pendular
