#include "sim/catalogue/effect.h"

namespace pendular {

/// A load cell that was not tared, or the lid's own weight, adds a constant to the normal force.
/// Stress ratios have a relative error of -force/F_N, largest at the smallest load. Inertial
/// numbers have half of this error.
Effect normal_force_offset() {
    return {.summary = "a wrong tare of the load cell adds a constant normal force",
            .equation = "F_shown = F_N + force",
            .parameters = {{.name = "force",
                            .unit = "N",
                            .lower = -10,
                            .upper = 10,
                            .neutral = 0,
                            // Chosen: 3 % of the force at 0.3 kPa in a cell of 21 and 45 mm.
                            .smallest_of_interest = 0.05,
                            .meaning = "normal force that the load cell shows without a load"}},
            .change = ChangeInstrument{.show =
                                           [](CellState shown, const Values& v) {
                                               shown.normal_force += v["force"];
                                               return shown;
                                           },
                                       .where = ChangeInstrument::Where::transducers},
            .acts_through = {"1/normal_stress"},
            .directly = "the tare: the normal force that the unloaded lid shows",
            .references = {"Schulze, Powders and Bulk Solids (2008): counterweight and tare of the "
                           "normal load of ring shear testers"}};
}

}  // namespace pendular
