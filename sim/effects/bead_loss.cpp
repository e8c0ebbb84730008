#include "sim/catalogue/effect.h"

namespace pendular {

/// Beads have left the cell through the clearances of the lid since a balance weighed them before
/// the test. The shown solid fraction and the shown weight still include the lost beads. The effect
/// is applied with the transducers, after the effects on the beads in the cell.
Effect bead_loss() {
    return {.summary = "beads have left the cell since they were weighed",
            .equation = "V_S shown = V_S/(1 - fraction)",
            .parameters = {{.name = "fraction",
                            .unit = "1",
                            .lower = 0,
                            .upper = 0.2,
                            .neutral = 0,
                            // Chosen: changes the shown solid fraction by 1 %.
                            .smallest_of_interest = 0.01,
                            .meaning = "share of the weighed beads that is no longer in the cell"}},
            .change = ChangeInstrument{.show =
                                           [](CellState shown, const Values& v) {
                                               shown.bead_volume /= 1 - v["fraction"];
                                               return shown;
                                           },
                                       .where = ChangeInstrument::Where::transducers},
            .acts_through = {"bead_volume"},
            .directly = "weighing the beads before and after",
            .references = {"Schulze, Powders and Bulk Solids (2008): loss of bulk solid from the "
                           "gaps of shear cells"}};
}

}  // namespace pendular
