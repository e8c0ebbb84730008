#include "sim/catalogue/effect.h"

namespace pendular {

/// Every layer of beads carries the layers above, so that the normal stress rises by M g/A from lid
/// to bottom, with M the true mass of the beads in the cell. The average state of the beads is the
/// state at mid-height. There the normal stress exceeds the stress under the lid, which the load
/// cell measures, by M g/(2 A).
Effect grain_weight() {
    return {
        .summary =
            "the weight of the beads raises the normal stress at mid-height above that under the "
            "lid",
        .equation =
            "F_shown = F_N - M g/2      F_N at mid-height, M the mass of the beads in the cell",
        .parameters = {on_switch(
            "the weight of the beads in the cell is included instead of neglected")},
        .change = ChangeInstrument{.show =
                                       [](CellState shown, const Values& v) {
                                           shown.normal_force -= v["on"] * shown.weight() / 2;
                                           return shown;
                                       },
                                   .where = ChangeInstrument::Where::grains},
        .acts_through = {"1/normal_stress", "bead_volume"},
        .certain = "the weight of the beads follows from the bead mass in study.toml",
        .references = {"Badetti, Fall, Chevoir and Roux, Shear strength of wet granular materials: "
                       "macroscopic cohesion and effective stress (2018)",
                       "Janssen, Z. Ver. dt. Ing. 39 (1895) 1045"}};
}

}  // namespace pendular
