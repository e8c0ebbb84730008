#include "sim/catalogue/effect.h"

namespace pendular {

/// A table of readings has a constant in all shear stresses, such as the drag of bearings and
/// seals. Its contribution to the stress ratio resembles a cohesion, also for dry beads.
Effect shear_stress_offset() {
    return {
        .summary = "drag of the instrument adds a constant to every shear stress of a table",
        .equation = "s12_shown = s12 + stress",
        .parameters = {{.name = "stress",
                        .unit = "Pa",
                        .lower = -1000,
                        .upper = 1000,
                        .neutral = 0,
                        // Chosen: about 1 % of the shear stress at 0.3 kPa.
                        .smallest_of_interest = 1,
                        .meaning = "constant stress that is added to the true shear stress"}},
        .change = ChangeInstrument{.show =
                                       [](CellState shown, const Values& v) {
                                           shown.torque += shown.torque_of(v["stress"]);
                                           return shown;
                                       },
                                   .where = ChangeInstrument::Where::table},
        .acts_through = {"1/normal_stress"},
        .directly = "the shear stress that the empty cell shows while it turns",
        .references = {"Schulze, Powders and Bulk Solids (2008), section 4.3: tare of the shear "
                       "force of ring shear testers"}};
}

}  // namespace pendular
