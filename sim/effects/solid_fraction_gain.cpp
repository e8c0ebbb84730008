#include "sim/catalogue/effect.h"

namespace pendular {

/// A table of readings has all solid fractions too high or too low by the same factor: a wrong mass
/// or density of the beads, a wrong area, or beads lost from the cell.
Effect solid_fraction_gain() {
    return {
        .summary =
            "a wrong mass, density or area multiplies every solid fraction of a table by a "
            "constant",
        .equation = "Phi_shown = gain Phi",
        .parameters =
            {{.name = "gain",
              .unit = "1",
              .lower = 0.5,
              .upper = 2,
              .neutral = 1,
              // Chosen: 0.5 %, about what a bead mass weighed in a shaken cell is uncertain by.
              .smallest_of_interest = 0.005,
              .meaning = "shown solid fraction over true solid fraction"}},
        .change = ChangeInstrument{.show =
                                       [](CellState shown, const Values& v) {
                                           shown.bead_volume *= v["gain"];
                                           return shown;
                                       },
                                   .where = ChangeInstrument::Where::table},
        .acts_through = {"solid_fraction"},
        .directly =
            "the mass and density of the beads and the area that the fraction was computed with",
        .references = {
            "Schulze, Powders and Bulk Solids (2008): calibration of ring shear testers"}};
}

}  // namespace pendular
