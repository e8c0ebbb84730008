#include "sim/catalogue/effect.h"

namespace pendular {

/// A table of readings has all normal stresses too high or too low by the same factor: a load cell
/// whose calibration has drifted, or a force divided by a wrong area, such as that of the full disc
/// in place of the annulus. Stress ratios are then wrong by 1/gain. Inertial numbers change by
/// sqrt(gain) and reduced pressures by 1/gain, which tells this gain from that of the shear stress.
Effect normal_stress_gain() {
    return {.summary =
                "a wrong calibration or a wrong area multiplies every normal stress of a table by "
                "a constant",
            .equation = "s22_shown = gain s22",
            .parameters = {{.name = "gain",
                            .unit = "1",
                            .lower = 0.5,
                            .upper = 2,
                            .neutral = 1,
                            // Chosen: 2 %, the error that readings without replicates are given.
                            .smallest_of_interest = 0.02,
                            .meaning = "shown normal stress over true normal stress"}},
            .change = ChangeInstrument{.show =
                                           [](CellState shown, const Values& v) {
                                               shown.normal_force *= v["gain"];
                                               return shown;
                                           },
                                       .where = ChangeInstrument::Where::table},
            .acts_through = {"normal_stress"},
            .directly =
                "calibration weights on the load cell, and the area that the force was divided by",
            .references = {
                "Schulze, Powders and Bulk Solids (2008): calibration of ring shear testers"}};
}

}  // namespace pendular
