#include "sim/catalogue/effect.h"

namespace pendular {

/// Every layer carries those above it, so that the normal stress rises over the depth by M g/A.
/// Beads are in the state of mid-height on average, where it is half of that more than under the
/// lid, which the load cell feels. M is the mass truly in the cell.
Effect grain_weight() {
    return {
        .summary = "the beads' own weight: at mid-height the stress is higher than under the lid",
        .equation =
            "F_shown = F_N - M g/2      F_N at mid-height, M the mass of the beads in the cell",
        .parameters = {on_switch("0: weightless, 1: the weight of the beads counts")},
        .change = ChangeInstrument{.show =
                                       [](CellState shown, const Values& v) {
                                           shown.normal_force -= v["on"] * shown.weight() / 2;
                                           return shown;
                                       },
                                   .where = ChangeInstrument::Where::grains},
        .acts_through = {"1/normal_stress", "bead_volume"},
        .references = {"Badetti, Fall, Chevoir and Roux, Shear strength of wet granular materials: "
                       "macroscopic cohesion and effective stress (2018)",
                       "Janssen, Z. Ver. dt. Ing. 39 (1895) 1045"}};
}

}  // namespace pendular
