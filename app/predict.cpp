// `pendular predict`: what known runs say of any state, without a new one.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "app/command.h"
#include "app/console.h"
#include "app/interrupt.h"
#include "app/options.h"
#include "app/requested_state.h"
#include "app/stored_runs.h"
#include "data/input_error.h"
#include "data/nearest.h"
#include "data/number.h"
#include "data/text_file.h"
#include "reports/draw_figure.h"
#include "reports/prediction_figure.h"
#include "workflow/known_runs.h"

namespace pendular::app {
namespace {

using nlohmann::ordered_json;

/// What a curve varies, and how.
struct Along {
    std::string name;
    double from = 0, to = 0;
    int points = 60;
    bool logarithmic = false;

    double at(int k) const {
        const double part = static_cast<double>(k) / (points - 1);
        return logarithmic ? from * std::pow(to / from, part) : from + (to - from) * part;
    }
    void set(RequestedState& requested, double value) const {
        if (name == "friction") {
            requested.friction = value;
        } else if (name == "inertial_number") {
            requested.inertial_number = value;
        } else if (name == "reduced_pressure") {
            requested.reduced_pressure = value;
        } else if (name == "bridge_volume") {
            requested.bridge_volume = value;
        } else {
            requested.liquid_content = value;
        }
    }
};

/// "reduced-pressure=0.5:10".
/// @throws InputError for any other text
Along along_from(const std::string& text, int points) {
    const std::vector<std::string> names = {"friction", "inertial-number", "reduced-pressure",
                                            "bridge-volume", "liquid-content"};
    const auto equals = std::min(text.find('='), text.size());
    const auto colon = std::min(text.find(':', equals), text.size());
    const std::string name = text.substr(0, equals);
    const auto number = [&](std::size_t begin, std::size_t end) {
        return begin < text.size() ? parse_number(text.substr(begin, end - begin)) : std::nullopt;
    };
    const auto from = number(equals + 1, colon), to = number(colon + 1, text.size());
    if (std::ranges::find(names, name) == names.end()) {
        throw InputError(fmt::format("--along {}: nothing to vary is called '{}'; {}", text, name,
                                     did_you_mean(name, names)));
    }
    if (!from || !to || !(*from < *to) || points < 2) {
        throw InputError(fmt::format(
            "--along {}: two numbers are needed, the lesser first, as in {}=0.5:10", text, name));
    }
    Along along{.name = name, .from = *from, .to = *to, .points = points};
    along.logarithmic = name != "friction" && *from > 0;
    std::ranges::replace(along.name, '-', '_');
    return along;
}

ordered_json uncertain(const Estimate& estimate) {
    return {{"value", estimate.value}, {"stderr", estimate.standard_error}};
}

ordered_json state_json(const FlowState& state,
                        const std::vector<EmulatedObservable>& observables) {
    ordered_json json = {{"friction", state.friction},
                         {"inertial_number", state.inertial_number},
                         {"reduced_pressure", nullptr},
                         {"bridge_volume", nullptr}};
    if (!state.dry()) {
        json["reduced_pressure"] = 1 / state.inverse_pressure;
        json["bridge_volume"] = state.bridge_volume;
    }
    constexpr const char* inputs[] = {"friction", "log_inertial_number", "inverse_reduced_pressure",
                                      "bridge_volume"};
    for (const auto& one : observables) {
        const std::string name(dem::observable_names[static_cast<std::size_t>(one.which)]);
        json[name] = uncertain(one.value);
        for (std::size_t k = 0; k < one.slopes.size(); ++k) {
            json[name]["by"][inputs[k]] = uncertain(one.slopes[k]);
        }
    }
    return json;
}

/// What a prediction rests on and how it is answered.
struct PredictionTask {
    const Emulator& emulator;
    const KnownRange& known;
    const CommonOptions& common;
    double stiffness_number;
    Console& console;
};

/// The name of the observable with its value and standard error.
std::string observable_line(dem::Observable which, double value, double standard_error) {
    return fmt::format("{:<32} {:>22}", dem::observable_names[static_cast<std::size_t>(which)],
                       with_error(value, standard_error));
}

/// Solid fractions of very soft grains, to which the correction leads, may leave what packings
/// have.
/// @throws InputError for them
void demand_physical(const std::vector<EmulatedObservable>& observables, double stiffness_number) {
    for (const auto& one : observables) {
        if (one.which == dem::Observable::solid_fraction &&
            !(one.value.value >= KnownRange::lowest_fraction &&
              one.value.value <= KnownRange::highest_fraction)) {
            throw InputError(
                fmt::format("--stiffness-number {:g}: the solid fraction would be {:.3g}, which is "
                            "not between {} and {}; give a larger stiffness number",
                            stiffness_number, one.value.value, KnownRange::lowest_fraction,
                            KnownRange::highest_fraction));
        }
    }
}

std::vector<EmulatedObservable> predicted_at(const FlowState& state, const PredictionTask& p) {
    auto observables = emulated_at(p.emulator, state, p.stiffness_number, observables_of(state));
    demand_physical(observables, p.stiffness_number);
    return observables;
}

/// Notes what makes a simulated answer another than the requested one.
void note_differences(const RequestedState& requested, const dem::RunResult& run,
                      Console& console) {
    if (run.parameters.inertial_number != requested.inertial_number) {
        console.note(fmt::format(
            "The simulation has an inertial number of {:g}, the lowest of this fidelity, instead "
            "of {:g}.",
            run.parameters.inertial_number, requested.inertial_number));
    }
    if (requested.liquid_content) {
        const Mean& content = run[dem::Observable::liquid_content];
        console.note(fmt::format("The simulation has a liquid content of {}, requested was {:g}.",
                                 with_error(content.value, content.standard_error),
                                 *requested.liquid_content));
    }
    if (run.crystallised) {
        console.note("The sample crystallised: its averages are not those of a random packing.");
    }
    if (!run.steady) {
        console.note("The simulation found no steady state; a higher fidelity shears longer.");
    }
}

/// Answers by a simulation of the state, which is kept in the store.
/// @throws InputError for a state that cannot be simulated
void simulate_one(const RequestedState& requested, const FlowState& state, const PredictionTask& p,
                  RunStore* store) {
    const dem::RunParameters wanted =
        run_of(with_known_coordination(requested, state, p.emulator, p.known), p.common.fidelity,
               p.stiffness_number);
    if (const std::string why = why_impossible(wanted); !why.empty()) {
        throw InputError("--simulate: " + why);
    }
    const InterruptGuard guard;
    const Workers workers{
        .threads = p.common.threads,
        .stop = guard.token(),
        .report = [&](const EnsembleProgress& at) { p.console.progress("simulating", at); },
        .store = store};
    const dem::RunResult run = run_all({wanted}, workers).front();
    p.console.end_progress();
    if (!run.failure.empty()) {
        throw std::runtime_error("the simulation failed: " + run.failure);
    }
    ordered_json json = state_json(Emulator::state_of(wanted), {});
    for (const dem::Observable which : observables_of(state)) {
        const Mean& mean = run[which];
        p.console.line(observable_line(which, mean.value, mean.standard_error));
        json[std::string(dem::observable_names[static_cast<std::size_t>(which)])] =
            uncertain({mean.value, mean.standard_error});
    }
    p.console.line(
        fmt::format("Simulated at {} fidelity, since the known runs do not support a prediction: "
                    "{} grains, averaged strain {:.3g}, stiffness number {:.4g}.{}",
                    p.common.fidelity.name, wanted.beads, run.strain_averaged, p.stiffness_number,
                    store ? " The run is in " + store->file().string() + "." : ""));
    note_differences(requested, run, p.console);
    json["stiffness_number"] = p.stiffness_number;
    json["simulated"] = true;
    p.console.json(json);
}

void predict_one(const RequestedState& requested, const PredictionTask& p, bool simulate,
                 RunStore* store) {
    const FlowState state = requested.state(p.emulator, p.known);
    if (const std::string why = p.known.why_unsupported(state); !why.empty()) {
        if (simulate) {
            return simulate_one(requested, state, p, store);
        }
        throw InputError(unsupported_text(requested, state, why, p.emulator, p.known,
                                          p.common.fidelity, p.stiffness_number));
    }
    const auto observables = predicted_at(state, p);
    for (const auto& one : observables) {
        p.console.line(observable_line(one.which, one.value.value, one.value.standard_error));
    }
    p.console.line(
        fmt::format("Predicted from {} runs{}; the solid fraction is that at stiffness number "
                    "{:.4g}.",
                    p.emulator.runs().size(),
                    simulate ? ", which support this state, so that nothing was simulated" : "",
                    p.stiffness_number));
    ordered_json json = state_json(state, observables);
    json["stiffness_number"] = p.stiffness_number;
    json["beyond"] = p.emulator.beyond(state);
    json["runs"] = p.emulator.runs().size();
    json["simulated"] = false;
    p.console.json(json);
}

/// A variable in words: "inertial number".
std::string spoken(std::string name) {
    std::ranges::replace(name, '_', ' ');
    return name;
}

/// Says which part of a curve the known runs support.
void note_left_out(const Along& along, const PredictionCurve& curve, const std::string& why,
                   Console& console) {
    const std::size_t left_out = static_cast<std::size_t>(along.points) - curve.at.size();
    if (left_out > 0) {
        console.note(fmt::format(
            "{} of {} states are left out, since the known runs do not support them ({}). Kept is "
            "{} {:.4g} to {:.4g}. 'pendular simulate' or 'pendular campaign' makes runs beyond.",
            left_out, along.points, why, spoken(along.name), curve.at.front(), curve.at.back()));
    }
}

void predict_along(RequestedState requested, const Along& along, const PredictionTask& p) {
    PredictionCurve curve{.variable = along.name, .stiffness_number = p.stiffness_number};
    ordered_json json = {{"along", along.name}, {"states", ordered_json::array()}};
    std::string why;  // the first state is left out, and which that is
    std::optional<RequestedState> left_out;
    for (int k = 0; k < along.points; ++k) {
        along.set(requested, along.at(k));
        const FlowState state = requested.state(p.emulator, p.known);
        if (const std::string unsupported = p.known.why_unsupported(state); !unsupported.empty()) {
            if (!left_out) {
                left_out = requested, why = unsupported;
            }
            continue;
        }
        curve.at.push_back(along.at(k));
        curve.states.push_back(state);
        curve.observables.push_back(predicted_at(state, p));
        json["states"].push_back(state_json(state, curve.observables.back()));
    }
    if (curve.at.size() < 2) {
        throw InputError(fmt::format(
            "--along: {} of {} states can be predicted, a curve needs 2; {}", curve.at.size(),
            along.points,
            unsupported_text(*left_out, left_out->state(p.emulator, p.known), why, p.emulator,
                             p.known, p.common.fidelity, p.stiffness_number)));
    }
    const std::filesystem::path folder = p.common.out.value_or(".");
    write_whole(folder / "prediction.csv", prediction_table(curve));
    draw(prediction_figure(curve, p.emulator), folder / "figures");
    p.console.line(fmt::format("{} states from {} runs are written to {} and {}.", curve.at.size(),
                               p.emulator.runs().size(), (folder / "prediction.csv").string(),
                               (folder / "figures" / "prediction.png").string()));
    note_left_out(along, curve, why, p.console);
    json["left_out"] = along.points - static_cast<int>(curve.at.size());
    p.console.json(json);
}

}  // namespace

int predict(const std::vector<std::string>& arguments) {
    Options options(
        "predict [options]",
        "Tells at once what steady shear of beads would measure, with standard errors, "
        "from the runs of the\n"
        "atlas and of the store. Refuses a state that these runs do not support: outside of their "
        "convex hull,\n"
        "with a standard error above 15 % of the stress ratio or 2 % of the solid fraction, or "
        "with "
        "values that\n"
        "no flow has. With --along, a curve as CSV and figure, as far as it is supported.",
        "  pendular predict --friction 0.09\n"
        "  pendular predict --friction 0.09 --reduced-pressure 1 --liquid-content 0.03\n"
        "  pendular predict --reduced-pressure 3 --bridge-volume 0.004 --json -\n"
        "  pendular predict --friction 0.8 --simulate --fidelity quick\n"
        "  pendular predict --along reduced-pressure=0.5:50 --liquid-content 0.03 --out "
        "curve\n",
        false);
    options.set_out("folder for prediction.csv and the figure of --along (default: here)");
    RequestedState requested;
    double pressure = 0, volume = 0, content = 0, stiffness_number = 0;
    options.add("friction", &requested.friction,
                "intergranular friction coefficient [1] (default 0.09)");
    options.add("inertial-number", &requested.inertial_number,
                "shear rate times sqrt(m/(a s22)) [1] (default 0, the quasi-static limit)");
    options.add("reduced-pressure", &pressure, "P* = a^2 s22/F0 of wet beads [1] (default: dry)");
    options.add("bridge-volume", &volume, "volume of a liquid bridge over a^3 [1]");
    options.add("liquid-content", &content, "liquid volume over bead volume [1], instead of that");
    options.add("stiffness-number", &stiffness_number,
                "(E/(1 - nu^2)/s22)^(2/3), to which the solid fraction is corrected [1] (default: "
                "the fidelity's)");
    std::string along;
    int points = 60;
    options.add("along", &along, "NAME=FROM:TO of the one number to vary");
    options.add("points", &points, "states along it (default 60)");
    bool simulate = false;
    options.add_switch("simulate", &simulate,
                       "where the known runs do not support the state, simulate it at the "
                       "--fidelity, keep the run in the store and answer from it");
    const auto common = options.parse(arguments);
    if (!common) {
        return done;
    }
    const auto take = [&](const char* name, double value, std::optional<double>& into) {
        if (options.given(name)) {
            into = value;
        }
    };
    take("reduced-pressure", pressure, requested.reduced_pressure);
    take("bridge-volume", volume, requested.bridge_volume);
    take("liquid-content", content, requested.liquid_content);
    if (simulate && !along.empty()) {
        throw InputError(
            "--simulate answers for one state; with --along, 'pendular campaign' makes the runs");
    }
    std::optional<Along> line;
    if (!along.empty()) {
        line = along_from(along, points);
        for (const double end : {line->from, line->to}) {
            RequestedState at = requested;
            line->set(at, end);
            at.check();
        }
    } else {
        requested.check();
    }
    if (!options.given("stiffness-number")) {
        stiffness_number = common->fidelity.stiffness_number;
    }
    if (!(stiffness_number >= 100)) {
        throw InputError(
            fmt::format("--stiffness-number {}: 100 or more is needed", stiffness_number));
    }
    Console console(*common);
    const auto store = open_store(*common);
    auto known = known_runs(Study{}, common->fidelity, store.get());
    if (!known) {
        throw InputError(
            "there are too few runs to predict from; name an atlas in PENDULAR_ATLAS, or make runs "
            "with 'pendular campaign'");
    }
    const Emulator emulator(known->runs, std::move(known->scales));
    const KnownRange range(emulator);
    const PredictionTask prediction{emulator, range, *common, stiffness_number, console};
    if (line) {
        predict_along(requested, *line, prediction);
    } else {
        predict_one(requested, prediction, simulate, store.get());
    }
    return done;
}

}  // namespace pendular::app
