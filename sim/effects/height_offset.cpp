#include "sim/catalogue/effect.h"

namespace pendular {

/// The gap has a constant error where it was zeroed with beads, dust or liquid between the plates,
/// or where the frame gives way under load. Solid fraction and shear rate then have a relative
/// error of -offset/H.
Effect height_offset() {
    return {
        .summary = "a wrong zero of the gap adds a constant to the gap height",
        .equation = "H_shown = H + offset",
        .parameters = {{.name = "offset",
                        .unit = "m",
                        .lower = -2e-3,
                        .upper = 2e-3,
                        .neutral = 0,
                        // Chosen: 0.1 % of a height of 20 mm, and so of the solid fraction.
                        .smallest_of_interest = 20e-6,
                        .meaning = "shown height where the true height is 0"}},
        .change = ChangeInstrument{.show =
                                       [](CellState shown, const Values& v) {
                                           shown.height += v["offset"];
                                           return shown;
                                       },
                                   .where = ChangeInstrument::Where::transducers},
        .acts_through = {"1/height"},
        .directly = "a gauge block under the lid",
        .references = {
            "Schulze, Powders and Bulk Solids (2008): height of the sample in ring shear testers",
            "Davies and Stokes, J. Non-Newtonian Fluid Mech. 148 (2008) 73: errors of the gap of "
            "rheometers"}};
}

}  // namespace pendular
