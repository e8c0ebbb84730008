#include "reports/simulation_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "calib/emulator/emulated_observables.h"
#include "data/input_error.h"
#include "data/quantities/quantity.h"
#include "reports/figure_style.h"

namespace pendular {
namespace {

using dem::Observable;

struct Variable {
    const char* name;
    const char* label;
    bool log;
    double (*of)(const FlowState&);
    bool wet = false;  ///< whether only wet grains have the quantity
};

constexpr Variable variables[] = {
    {"friction", "intergranular friction μ", false, [](const FlowState& s) { return s.friction; }},
    {"inertial_number", "inertial number I", true,
     [](const FlowState& s) { return s.inertial_number; }},
    {"reduced_pressure", "reduced pressure P*", true,
     [](const FlowState& s) { return 1 / s.inverse_pressure; }, true},
    {"bridge_volume", "bridge volume V_0/a^3", true,
     [](const FlowState& s) { return s.bridge_volume; }, true},
    {"liquid_content", "liquid content Φ_L/Φ_S", true, nullptr, true}};

const Variable& variable_named(const std::string& name) {
    return *std::ranges::find(variables, name, &Variable::name);
}

/// Whether a run agrees within 5 % with the states of a curve in all quantities but the variable,
/// and in the stiffness number.
bool beside(const dem::RunResult& run, const PredictionCurve& curve, const Variable& variable) {
    constexpr double tolerance = 0.05;
    const FlowState state = emulated::flow_state_of(run.parameters), &line = curve.states.front();
    const auto close = [](double a, double b) {
        return std::abs(a - b) <= tolerance * std::max(std::abs(a), std::abs(b));
    };
    if (state.dry() != line.dry() ||
        !close(run.parameters.stiffness_number, curve.stiffness_number)) {
        return false;
    }
    return std::ranges::all_of(variables, [&](const Variable& other) {
        const bool compared = other.of && other.name != variable.name && !(other.wet && line.dry());
        return !compared || close(other.of(state), other.of(line));
    });
}

std::string subtitle(const PredictionCurve& curve) {
    const FlowState& s = curve.states.front();
    std::string text;
    const auto say = [&](const char* name, const std::string& what) {
        if (curve.variable != name) {
            text += (text.empty() ? "" : ", ") + what;
        }
    };
    say("friction", fmt::format("μ = {:.3g}", s.friction));
    say("inertial_number", fmt::format("I = {:.3g}", s.inertial_number));
    if (!s.dry()) {
        say("reduced_pressure", fmt::format("P* = {:.3g}", 1 / s.inverse_pressure));
        if (curve.variable != "liquid_content") {
            say("bridge_volume", fmt::format("V_0 = {:.3g} a^3", s.bridge_volume));
        }
    }
    return text;
}

const Estimate& value_of(const std::vector<EmulatedObservable>& observables, Observable which) {
    return std::ranges::find(observables, which, &EmulatedObservable::which)->value;
}

bool is_observable(const std::string& name) {
    return std::ranges::find(dem::observable_names, name) != std::end(dem::observable_names);
}

/// Label of an axis for an observable: its name in words and its symbol.
std::string label_of(Observable which) {
    if (which == Observable::stress_ratio) return stress_ratio_label;
    if (which == Observable::solid_fraction) return solid_fraction_label;
    const Quantity& about = quantity(dem::observable_names[static_cast<std::size_t>(which)]);
    std::string words(about.name);
    std::ranges::replace(words, '_', ' ');
    return fmt::format("{} {} [1]", words, about.symbol);
}

/// Panel of an observable: emulated curve with its standard errors, and runs beside it.
Panel panel_of(Observable which, const PredictionCurve& curve, const Emulator& emulator) {
    const Variable& variable = variable_named(curve.variable);
    Curve line{.label = "emulator, ± 1 standard error",
               .style = Curve::Style::line,
               .x = curve.at,
               .y = {},
               .y_error = {},
               .colour = model_colour};
    Curve band = line;
    band.style = Curve::Style::band;
    band.in_key = false;
    line.banded = true;
    line.in_table = false;
    for (const auto& observables : curve.observables) {
        const Estimate& value = value_of(observables, which);
        line.y.push_back(value.value);
        band.y.push_back(value.value);
        band.y_error.push_back(value.standard_error);
    }
    Curve runs{
        .label = "simulations", .colour = run_colour, .symbol = {Shape::circle, Filling::hollow}};
    for (const auto& run : emulator.runs()) {
        if (variable.of && beside(run, curve, variable)) {
            const Mean& mean = run[which];
            runs.x.push_back(variable.of(emulated::flow_state_of(run.parameters)));
            runs.y.push_back(mean.value);
            runs.y_error.push_back(mean.standard_error);
        }
    }
    Panel panel{.y_label = label_of(which)};
    panel.curves = {band, line};
    if (!runs.x.empty()) {
        panel.curves.push_back(runs);
    }
    return panel;
}

/// Panel of a closure's values from the emulated state.
Panel panel_of(const closures::ClosureQuantity& closure, const PredictionCurve& curve) {
    Curve line{.label = "formula from emulated values",
               .style = Curve::Style::line,
               .x = curve.at,
               .y = {},
               .y_error = {},
               .colour = model_colour};
    for (const closures::ClosureValues& values : curve.closures) {
        line.y.push_back(values.*closure.value);
    }
    Panel panel{.y_label = closure.label};
    panel.curves = {line};
    return panel;
}

}  // namespace

void check_drawable(const std::string& name, const PredictionCurve& curve) {
    std::vector<std::string> names;
    for (const auto& one : curve.observables.front()) {
        names.emplace_back(dem::observable_names[static_cast<std::size_t>(one.which)]);
    }
    if (!curve.closures.empty()) {
        for (const auto& each : closures::closure_quantities) {
            names.emplace_back(each.name);
        }
    }
    if (std::ranges::find(names, name) == names.end()) {
        throw InputError(
            fmt::format("--draw {}: {} grains have no observable or formula of this "
                        "name; {}",
                        name, curve.closures.empty() ? "dry" : "wet", did_you_mean(name, names)));
    }
}

Figure prediction_figure(const PredictionCurve& curve, const Emulator& emulator,
                         const std::vector<std::string>& drawn) {
    Figure figure{.name = "prediction",
                  .title = "Emulated steady shear, " + subtitle(curve),
                  .panels = {},
                  .stacked = true};
    for (const std::string& name : drawn) {
        const auto closure = std::ranges::find_if(
            closures::closure_quantities,
            [&](const auto& each) { return each.name == name && !is_observable(name); });
        Panel panel = closure == closures::closure_quantities.end()
                          ? panel_of(dem::observable_named(name), curve, emulator)
                          : panel_of(*closure, curve);
        const Variable& variable = variable_named(curve.variable);
        panel.x_label = variable.label;
        panel.log_x = variable.log && curve.at.front() > 0;
        panel.key = figure.panels.empty();
        figure.panels.push_back(panel);
    }
    return figure;
}

std::string prediction_table(const PredictionCurve& curve) {
    std::string text = "friction,inertial_number,reduced_pressure,bridge_volume";
    for (const auto& one : curve.observables.front()) {
        const auto name = dem::observable_names[static_cast<std::size_t>(one.which)];
        text += fmt::format(",{},{}_stderr", name, name);
    }
    for (const auto& each : closures::closure_quantities) {
        if (!curve.closures.empty() && !is_observable(each.name))
            text += fmt::format(",{}", each.name);
    }
    text += '\n';
    for (std::size_t k = 0; k < curve.states.size(); ++k) {
        const FlowState& s = curve.states[k];
        text += fmt::format("{:.6g},{:.6g}", s.friction, s.inertial_number);
        text +=
            s.dry() ? ",," : fmt::format(",{:.6g},{:.6g}", 1 / s.inverse_pressure, s.bridge_volume);
        for (const auto& one : curve.observables[k]) {
            text += fmt::format(",{:.6g},{:.3g}", one.value.value, one.value.standard_error);
        }
        for (const auto& each : closures::closure_quantities) {
            if (!curve.closures.empty() && !is_observable(each.name))
                text += fmt::format(",{:.6g}", curve.closures[k].*each.value);
        }
        text += '\n';
    }
    return text;
}

}  // namespace pendular
