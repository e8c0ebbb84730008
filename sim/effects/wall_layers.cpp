#include "data/wall_layers.h"
#include "sim/catalogue/effect.h"

namespace pendular {

/// Grains beside a flat wall lie in layers, which should slide over each other more easily than
/// grains without order do. Of the torque, the shear stress times lever over the area of the lid, a
/// strip beside each wall adds nothing; its width is about half a diameter in cells of two widths
/// and several heights, loads and wall frictions. In one cell with beads of one size this is a
/// constant factor, as `torque-gain` is: no reading tells the two apart, but the width of the cell
/// and the diameter of the beads say how large this one is. The solid fraction is not changed: what
/// lid and base take of it is an offset of the gap (`height-offset`).
Effect wall_layers() {
    return {
        .summary =
            "grains beside the side walls lie in layers that shear easily, which lowers the "
            "torque",
        .equation =
            "T_shown = T (1 - 2 x 0.57 a/w)      w = Re - Ri, from 10 a on; a: grain diameter\n"
            "For equal beads that roll freely; half as much where sizes differ by 10 % or beads "
            "resist rolling.\n"
            "(docs/explanation/cell.md). A diagnosis tries it only where shear-localisation is "
            "tried: where\n"
            "wall_friction is stated in [cell] or the gap creeps.",
        .parameters = {on_switch(
            "the strength lost in layers beside the side walls is included instead of neglected")},
        .change = ChangeInstrument{.show =
                                       [](CellState shown, const Values& v) {
                                           if (v["on"] == 0) return shown;
                                           const double width = shown.width() / shown.diameter;
                                           shown.torque *=
                                               1 - v["on"] * strength_lost_beside_walls(width);
                                           return shown;
                                       },
                                   .where = ChangeInstrument::Where::grains},
        .of_uneven_shear = true,
        .acts_through = {"shear_stress"},
        .references = {
            "GDR MiDi, Eur. Phys. J. E 14 (2004) 341: layers of grains beside walls",
            "Desmond and Weeks, Phys. Rev. E 80 (2009) 051305: walls order packings within about a "
            "diameter, at a cost in proportion to 1/width"}};
}

}  // namespace pendular
