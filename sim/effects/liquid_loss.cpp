#include "sim/catalogue/effect.h"

#include <algorithm>
#include <cmath>

namespace pendular {
namespace {

/// Largest exponent. It leaves e^-100 of the liquid, that is none; far larger ones would overflow.
constexpr double gone = 100;

}  // namespace

/// Liquid evaporates, or drains to the walls, at a rate proportional to the remaining liquid. The
/// liquid content known from mixing is right only when the first recording begins. The effect is
/// applied with the transducers, since the shown liquid content is the reading of a balance.
Effect liquid_loss() {
    return {
        .summary = "the liquid evaporates or drains during the recordings",
        .equation =
            "Phi_L/Phi_S shown = Phi_L/Phi_S exp(rate t)      t since the first recording began",
        .parameters = {{.name = "rate",
                        .unit = "1/s",
                        .lower = 0,
                        .upper = 1,
                        .neutral = 0,
                        // Chosen: 4 % of the liquid in an hour.
                        .smallest_of_interest = 1e-5,
                        .meaning = "share of the liquid that is lost per time"}},
        .change = ChangeInstrument{.show =
                                       [](CellState shown, const Values& v) {
                                           shown.liquid_content *=
                                               std::exp(std::min(v["rate"] * shown.time, gone));
                                           return shown;
                                       },
                                   .where = ChangeInstrument::Where::transducers},
        .touches = Touches::wet,
        .acts_through = {"time"},
        .directly = "weighing the cell before and after",
        .references = {"Mitarai and Nori, Adv. Phys. 55 (2006) 1: wet granular materials"}};
}

}  // namespace pendular
