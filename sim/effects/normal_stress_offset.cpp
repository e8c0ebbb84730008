#include "sim/catalogue/effect.h"

namespace pendular {

/// A table of readings has a constant in all normal stresses, such as the weight of the lid or of
/// the grains above the plane of shear. Stress ratios have a relative error of -stress/s22.
Effect normal_stress_offset() {
    return {.summary = "a wrong tare adds a constant to every normal stress of a table",
            .equation = "s22_shown = s22 + stress",
            .parameters = {{.name = "stress",
                            .unit = "Pa",
                            .lower = -1000,
                            .upper = 1000,
                            .neutral = 0,
                            // Chosen: 3 % of the normal stress at 0.3 kPa.
                            .smallest_of_interest = 10,
                            .meaning = "normal stress that is shown without a load"}},
            .change = ChangeInstrument{.show =
                                           [](CellState shown, const Values& v) {
                                               shown.normal_force += v["stress"] * shown.area();
                                               return shown;
                                           },
                                       .where = ChangeInstrument::Where::table},
            .acts_through = {"1/normal_stress"},
            .directly = "the tare: the normal stress that the unloaded lid shows",
            .references = {"Schulze, Powders and Bulk Solids (2008): counterweight and tare of the "
                           "normal load of ring shear testers"}};
}

}  // namespace pendular
