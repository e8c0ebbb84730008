#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <utility>

#include "bench/hidden_effects/truth.h"

// Further effects that the program does not know, written without sight of the shapes that it
// proposes. Forces of the rig are 1.4 to 16 N, torques 0.01 to 0.2 N m, angular velocities 8 to
// 90 rad/s, gaps 19 mm; all recordings take 23 s, the dry ones the first 7 s.
namespace pendular::bench {
namespace {

constexpr double whole_study = 23;  // [s]

EffectParameter parameter(const std::string& name, const std::string& unit, double lower,
                          double upper, double smallest, const std::string& meaning) {
    return {.name = name,
            .unit = unit,
            .lower = lower,
            .upper = upper,
            .neutral = 0,
            .smallest_of_interest = smallest,
            .meaning = meaning};
}

ChangeInstrument transducer(std::function<CellState(CellState, const Values&)> show) {
    return {.show = std::move(show), .where = ChangeInstrument::Where::transducers};
}

OutsideEffect torque_nonlinearity() {
    return {{.name = "torque-nonlinearity",
             .summary = "the torque transducer's sensitivity changes with the torque",
             .equation = "T_shown = T (1 + curvature T/0.1 N m)",
             .parameters = {parameter("curvature", "1", -0.4, 0.8, 0.01,
                                      "relative change of the sensitivity at 0.1 N m")},
             .change = transducer([](CellState shown, const Values& v) {
                 constexpr double scale = 0.1;  // [N m]
                 shown.torque *= 1 + v["curvature"] * shown.torque / scale;
                 return shown;
             })},
            {{"torque", "stress_ratio"}, {"normal_stress"}}};
}

OutsideEffect sensor_resonance() {
    return {
        {.name = "sensor-resonance",
         .summary = "the shaft resonates at an angular velocity and shows too much torque there",
         .equation = "T_shown = T (1 + height/(1 + ((omega - 27 rad/s)/6 rad/s)^2))",
         .parameters = {parameter("height", "1", 0, 2, 0.02,
                                  "relative excess of the torque at the resonance")},
         .change = transducer([](CellState shown, const Values& v) {
             constexpr double resonance = 27, half_width = 6;  // [rad/s]
             const double off = (shown.angular_velocity - resonance) / half_width;
             shown.torque *= 1 + v["height"] / (1 + off * off);
             return shown;
         })},
        {{"torque", "stress_ratio"}, {"angular_velocity"}}};
}

OutsideEffect greased_seal() {
    return {{.name = "greased-seal",
             .summary = "the grease of a seal thins as it is sheared",
             .equation = "T_shown = T + drag (omega/50 rad/s)^0.5",
             .parameters = {parameter("drag", "N m", 0, 0.1, 1e-4, "drag torque at 50 rad/s")},
             .change = transducer([](CellState shown, const Values& v) {
                 constexpr double scale = 50;  // [rad/s]
                 shown.torque +=
                     v["drag"] * std::sqrt(std::max(0.0, shown.angular_velocity) / scale);
                 return shown;
             })},
            {{"torque", "stress_ratio"}, {"angular_velocity"}}};
}

OutsideEffect shaft_compliance() {
    return {
        {.name = "shaft-compliance",
         .summary = "the shaft gives way axially, so that the gap shown is too small under load",
         .equation = "H_shown = H - compliance F_N",
         .parameters = {parameter("compliance", "m/N", 0, 1e-4, 1e-6,
                                  "axial compliance of shaft and frame")},
         .change = transducer([](CellState shown, const Values& v) {
             shown.height -= v["compliance"] * shown.normal_force;
             return shown;
         })},
        {{"height", "solid_fraction"}, {"normal_stress"}}};
}

OutsideEffect gap_drift() {
    return {{.name = "gap-drift",
             .summary = "the frame warms up, so that the gap shown drifts",
             .equation = "H_shown = H + rate t",
             .parameters = {parameter("rate", "m/s", -2e-4, 2e-4, 1e-6, "drift of the gap shown")},
             .change = transducer([](CellState shown, const Values& v) {
                 shown.height += v["rate"] * shown.time;
                 return shown;
             })},
            {{"height", "solid_fraction"}, {"time"}}};
}

/// As a torque it varies with the normal stress; as a stress ratio it is the same everywhere.
OutsideEffect force_cross_talk() {
    return {{.name = "force-cross-talk",
             .summary = "the torque transducer also feels a part of the normal force",
             .equation = "T_shown = T + arm F_N",
             .parameters = {parameter("arm", "m", -5e-3, 5e-3, 1e-5,
                                      "torque shown for each newton of normal force")},
             .change = transducer([](CellState shown, const Values& v) {
                 shown.torque += v["arm"] * shown.normal_force;
                 return shown;
             })},
            {{"torque", "stress_ratio"}, {"none", "normal_stress"}}};
}

OutsideEffect load_cell_creep() {
    return {{.name = "load-cell-creep",
             .summary = "the load cell creeps and shows more and more force",
             .equation = "N_shown = N (1 + creep (1 - exp(-t/8 s)))",
             .parameters = {parameter("creep", "1", -0.5, 1, 0.01,
                                      "relative change of the force after a long time")},
             .change = transducer([](CellState shown, const Values& v) {
                 constexpr double relaxation = 8;  // [s]
                 shown.normal_force *= 1 + v["creep"] * (1 - std::exp(-shown.time / relaxation));
                 return shown;
             })},
            {{"normal_force", "torque", "stress_ratio"}, {"time"}}};
}

/// Grains slide at about the shear rate times their diameter, I sqrt(s22/density): in a gap of
/// nearly constant height that is proportional to the angular velocity.
OutsideEffect velocity_weakening() {
    return {{.name = "velocity-weakening",
             .summary = "grains that slide faster rub less",
             .equation = "mu_p becomes mu_p - slope ln(v/0.02 m/s), v = I (s22/1050 kg/m^3)^0.5",
             .parameters = {parameter("slope", "1", -0.04, 0.04, 1e-3,
                                      "loss of friction for each e-fold of speed")},
             .change = ChangeCondition{[](EffectiveCondition condition, const Values& v) {
                 constexpr double scale = 0.02, density = 1050, least = 1e-3;
                 const double speed =
                     condition.inertial_number * std::sqrt(condition.normal_stress / density);
                 condition.friction_difference -=
                     v["slope"] * std::log(std::max(speed, least) / scale);
                 return condition;
             }}},
            {{"friction", "stress_ratio"}, {"angular_velocity"}}};
}

OutsideEffect pressure_friction() {
    return {{.name = "pressure-friction",
             .summary = "soft asperities flatten, so that friction falls with the normal stress",
             .equation = "mu_p becomes mu_p - slope ln(s22/900 Pa)",
             .parameters = {parameter("slope", "1", -0.07, 0.07, 1e-3,
                                      "loss of friction for each e-fold of normal stress")},
             .change = ChangeCondition{[](EffectiveCondition condition, const Values& v) {
                 constexpr double scale = 900;  // [Pa]
                 condition.friction_difference -=
                     v["slope"] * std::log(condition.normal_stress / scale);
                 return condition;
             }}},
            {{"friction", "stress_ratio"}, {"normal_stress"}}};
}

OutsideEffect wear() {
    return {{.name = "wear",
             .summary = "grains roughen each other, so that friction rises while they are sheared",
             .equation = "mu_p becomes mu_p + rise t/23 s",
             .parameters = {parameter("rise", "1", -0.1, 0.4, 5e-3,
                                      "friction at the end less that at the beginning")},
             .change = ChangeCondition{[](EffectiveCondition condition, const Values& v) {
                 condition.friction_difference += v["rise"] * condition.time / whole_study;
                 return condition;
             }}},
            {{"friction", "stress_ratio"}, {"time"}}};
}

OutsideEffect capillary_ageing() {
    return {{.name = "capillary-ageing",
             .summary = "the liquid takes up a surfactant and its surface tension falls",
             .equation = "Gamma becomes Gamma (1 - loss (1 - exp(-t/7 s)))",
             .parameters = {parameter("loss", "1", 0, 0.9, 0.02,
                                      "share of the surface tension that is lost in the end")},
             .change = ChangeCondition{[](EffectiveCondition condition, const Values& v) {
                 constexpr double relaxation = 7;  // [s]
                 condition.liquid->surface_tension *=
                     1 - v["loss"] * (1 - std::exp(-condition.time / relaxation));
                 return condition;
             }},
             .touches = Touches::wet},
            {{"surface_tension", "capillary_force", "stress_ratio"}, {"time"}}};
}

OutsideEffect swelling() {
    return {{.name = "swelling",
             .summary = "beads swell with the liquid that they take up",
             .equation = "V true = V weighed (1 + swelling (Phi_L/Phi_S)/0.03)",
             .parameters = {parameter("swelling", "1", 0, 0.3, 1e-3,
                                      "relative growth of the beads at a liquid content of 0.03")},
             .change = ChangeInstrument{.show =
                                            [](CellState shown, const Values& v) {
                                                constexpr double scale = 0.03;
                                                shown.bead_volume /= 1 + v["swelling"] *
                                                                             shown.liquid_content /
                                                                             scale;
                                                return shown;
                                            },
                                        .where = ChangeInstrument::Where::grains},
             .touches = Touches::wet},
            {{"bead_volume", "height", "solid_fraction"}, {"liquid_content"}}};
}

/// As a liquid content the offset is the same everywhere; what it does to the stress depends on the
/// liquid content.
OutsideEffect liquid_in_asperities() {
    return {{.name = "liquid-in-asperities",
             .summary = "the first liquid fills asperities and forms no bridges",
             .equation = "Phi_L/Phi_S of the bridges = Phi_L/Phi_S - threshold",
             .parameters = {parameter("threshold", "1", 0, 5.5e-3, 2e-4,
                                      "liquid content below which there are no bridges")},
             .change = ChangeInstrument{.show =
                                            [](CellState shown, const Values& v) {
                                                shown.liquid_content += v["threshold"];
                                                return shown;
                                            },
                                        .where = ChangeInstrument::Where::grains},
             .touches = Touches::wet},
            {{"liquid_content", "stress_ratio"}, {"none", "liquid_content"}}};
}

}  // namespace

const std::vector<OutsideEffect>& more_outside_effects() {
    static const std::vector<OutsideEffect> all = {torque_nonlinearity(), sensor_resonance(),
                                                   greased_seal(),        shaft_compliance(),
                                                   gap_drift(),           force_cross_talk(),
                                                   load_cell_creep(),     velocity_weakening(),
                                                   pressure_friction(),   wear(),
                                                   capillary_ageing(),    swelling(),
                                                   liquid_in_asperities()};
    return all;
}

RightShape right_shape(std::string_view effect) {
    for (const OutsideEffect& each : more_outside_effects()) {
        if (each.effect.name == effect) return each.shape;
    }
    if (effect == "lid-wobble" || effect == "torque-step") {
        return {{"torque", "stress_ratio"}, {"time"}};
    }
    if (effect == "load-cell-saturation") {
        return {{"normal_force", "torque", "stress_ratio"}, {"normal_stress"}};
    }
    if (effect == "merged-menisci") {
        return {{"surface_tension", "capillary_force", "stress_ratio"}, {"liquid_content"}};
    }
    throw std::invalid_argument("no shape is stated for an effect outside the catalogue");
}

}  // namespace pendular::bench
