#include <algorithm>
#include <cmath>

#include "bench/hidden_effects/truth.h"

// What a laboratory of the benchmark may hide and the program does not know. Their times and sizes
// suit the rig of the benchmark.
namespace pendular::bench {
namespace {

Effect lid_wobble() {
    return {.name = "lid-wobble",
            .summary = "a lid that is not level binds once a turn",
            .equation = "T_shown = T (1 + amplitude sin(omega t))",
            .parameters = {{.name = "amplitude",
                            .unit = "1",
                            .lower = -0.8,
                            .upper = 0.8,
                            .neutral = 0,
                            .smallest_of_interest = 0.02,
                            .meaning = "relative change of the torque"}},
            .change = ChangeInstrument{
                .show =
                    [](CellState shown, const Values& v) {
                        shown.torque *=
                            1 + v["amplitude"] * std::sin(shown.angular_velocity * shown.time);
                        return shown;
                    },
                .where = ChangeInstrument::Where::transducers}};
}

Effect load_cell_saturation() {
    constexpr double linear_up_to = 5;  // [N]
    return {.name = "load-cell-saturation",
            .summary = "the load cell shows too little of large forces",
            .equation = "N_shown = N up to 5 N, then only 1 - loss of what is above",
            .parameters = {{.name = "loss",
                            .unit = "1",
                            .lower = 0,
                            .upper = 0.9,
                            .neutral = 0,
                            .smallest_of_interest = 0.05,
                            .meaning = "share of a larger force that is not shown"}},
            .change = ChangeInstrument{.show =
                                           [](CellState shown, const Values& v) {
                                               shown.normal_force -=
                                                   v["loss"] *
                                                   std::max(0.0, shown.normal_force - linear_up_to);
                                               return shown;
                                           },
                                       .where = ChangeInstrument::Where::transducers}};
}

Effect torque_step() {
    constexpr double begins = 10;  // [s]
    return {.name = "torque-step",
            .summary = "a transducer that was knocked shows another torque from then on",
            .equation = "T_shown = T before t = 10 s, (1 + step) T after",
            .parameters = {{.name = "step",
                            .unit = "1",
                            .lower = -0.5,
                            .upper = 1,
                            .neutral = 0,
                            .smallest_of_interest = 0.02,
                            .meaning = "relative change of the torque"}},
            .change = ChangeInstrument{.show =
                                           [](CellState shown, const Values& v) {
                                               if (shown.time > begins) {
                                                   shown.torque *= 1 + v["step"];
                                               }
                                               return shown;
                                           },
                                       .where = ChangeInstrument::Where::transducers}};
}

Effect merged_menisci() {
    constexpr double merge_above = 0.02;
    return {.name = "merged-menisci",
            .summary = "above a liquid content bridges merge and pull less",
            .equation = "Gamma of the bridges becomes (1 - loss) Gamma where Phi_L/Phi_S > 0.02",
            .parameters = {{.name = "loss",
                            .unit = "1",
                            .lower = 0,
                            .upper = 0.9,
                            .neutral = 0,
                            .smallest_of_interest = 0.1,
                            .meaning = "share of the capillary force that is gone"}},
            .change = ChangeCondition{[](EffectiveCondition condition, const Values& v) {
                if (condition.liquid_content > merge_above) {
                    condition.liquid->surface_tension *= 1 - v["loss"];
                }
                return condition;
            }},
            .touches = Touches::wet};
}

}  // namespace

const std::vector<Effect>& outside_effects() {
    static const std::vector<Effect> all = {lid_wobble(), load_cell_saturation(), torque_step(),
                                            merged_menisci()};
    return all;
}

}  // namespace pendular::bench
