// `pendular predict`: predicts a state of steady shear from earlier simulations.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "app/closures.h"
#include "app/command.h"
#include "app/console.h"
#include "app/interrupt.h"
#include "app/observable_line.h"
#include "app/options.h"
#include "app/stored_runs.h"
#include "calib/emulator/emulated_observables.h"
#include "data/files/write_whole.h"
#include "data/input_error.h"
#include "reports/draw_figure.h"
#include "reports/prediction_figure.h"
#include "reports/with_error.h"
#include "sim/runs/ensemble.h"
#include "workflow/fit_runs.h"
#include "workflow/state_prediction_json.h"

namespace pendular::app {
namespace {

/// First line of the answer, "Predicted at friction 0.12, inertial number 0 (quasi-static), dry:
/// stress ratio 0.30 +- 0.01, solid fraction 0.600 +- 0.001."; `how` is the first word.
std::string answer_of(const char* how, const RequestedState& at, const Mean& stress_ratio,
                      const Mean& solid_fraction) {
    return fmt::format("{} at {}: stress ratio {}, solid fraction {}.", how, at.text(),
                       with_error(stress_ratio.value, stress_ratio.standard_error),
                       with_error(solid_fraction.value, solid_fraction.standard_error));
}

/// Prints notes where the simulated state differs from the requested state, crystallised or is not
/// steady.
void note_differences(const RequestedState& requested, const dem::RunResult& run,
                      Console& console) {
    if (run.parameters.inertial_number != requested.inertial_number) {
        console.note(
            fmt::format("The simulation has an inertial number of {:g}, the lowest one at this "
                        "fidelity, instead "
                        "of {:g}.",
                        run.parameters.inertial_number, requested.inertial_number));
    }
    if (requested.liquid_content) {
        const Mean& content = run[dem::Observable::liquid_content];
        console.note(fmt::format("The simulation has a liquid content of {}; the request was {:g}.",
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

/// Simulates a state at the fidelity of the options, keeps the run in the store, if there is one,
/// and prints the averages.
/// @throws std::runtime_error where the simulation fails
void simulate_one(const RequestedState& requested, const StatePredictor& predictor,
                  const CommonOptions& common, RunStore* store, Console& console) {
    const dem::RunParameters wanted = predictor.run_for(requested);
    const InterruptGuard guard;
    const Workers workers{
        .threads = common.threads,
        .stop = guard.token(),
        .report = [&](const EnsembleProgress& at) { console.progress("Simulation", at); },
        .store = store};
    const dem::RunResult run = run_all({wanted}, workers).front();
    console.end_progress();
    if (!run.failure.empty()) {
        throw std::runtime_error("the simulation failed: " + run.failure);
    }
    const auto simulated = [&run](dem::Observable which) { return run[which]; };
    RequestedState at = requested;
    at.inertial_number = run.parameters.inertial_number;
    console.answer(answer_of("Simulated", at, simulated(dem::Observable::stress_ratio),
                             simulated(dem::Observable::solid_fraction)));
    for (const dem::Observable which : observables_of(emulated::flow_state_of(wanted))) {
        console.line(observable_line(which, run[which]));
    }
    console.line(fmt::format(
        "Simulated at {} fidelity, since the simulations in atlas and store do not cover this "
        "state: {} grains, averages over a strain of {:.3g}, stiffness number {:.4g}.{}",
        common.fidelity.name, wanted.grains, run.strain_averaged, predictor.stiffness_number(),
        store ? " The result is in " + store->file().string() + "." : ""));
    note_differences(requested, run, console);
    console.json(simulated_state_json(wanted, run));
}

void predict_one(const RequestedState& requested, const StatePredictor& predictor, bool simulates,
                 Console& console) {
    const StatePrediction prediction = predictor.at(requested);
    const auto predicted = [&prediction](dem::Observable which) {
        const auto found = std::ranges::find_if(
            prediction.observables, [which](const auto& one) { return one.which == which; });
        return Mean{found->value.value, found->value.standard_error};
    };
    console.answer(answer_of("Predicted", requested, predicted(dem::Observable::stress_ratio),
                             predicted(dem::Observable::solid_fraction)));
    for (const auto& one : prediction.observables) {
        console.line(observable_line(one.which, {one.value.value, one.value.standard_error}));
    }
    if (prediction.closures) {
        print_closures(*prediction.closures, predicted(dem::Observable::stress_ratio).value,
                       console);
    }
    console.line(fmt::format(
        "The emulator was trained on {} simulations{}; the predictions hold for stiffness "
        "number {:.4g}.",
        prediction.runs, simulates ? ", which cover this state: nothing was simulated" : "",
        prediction.stiffness_number));
    auto json = to_json(prediction);
    json["runs"] = runs_json(predictor.emulator().runs());
    console.json(json);
}

/// Name of a variable with spaces in place of underscores: "inertial number".
std::string spoken(std::string name) {
    std::ranges::replace(name, '_', ' ');
    return name;
}

/// Prints a note on the part of a curve that is left out, since no earlier simulation is near.
void note_left_out(const PredictionCurve& curve, int points, Console& console) {
    if (curve.left_out > 0) {
        console.note(
            fmt::format("{} of {} states are left out, since the simulations in atlas and store do "
                        "not cover them ({}). The curve covers {} {:.4g} to {:.4g}. 'pendular "
                        "simulate' and 'pendular campaign' extend the range.",
                        curve.left_out, points, curve.why_left_out, spoken(curve.variable),
                        curve.at.front(), curve.at.back()));
    }
}

void predict_along(const RequestedState& requested, const VariedQuantity& varied,
                   const std::vector<std::string>& drawn, const StatePredictor& predictor,
                   const CommonOptions& common, Console& console) {
    const PredictionCurve curve = predictor.along(requested, varied);
    for (const std::string& name : drawn) {
        check_drawable(name, curve);
    }
    const std::filesystem::path folder = common.out.value_or(".");
    write_whole(folder / "prediction.csv", prediction_table(curve));
    auto json = to_json(curve);
    json["runs"] = runs_json(predictor.emulator().runs());
    console.json(json);  // before the figure, which needs gnuplot
    draw(prediction_figure(curve, predictor.emulator(), drawn), folder / "figures");
    console.answer(fmt::format(
        "{} states, predicted from {} simulations, are written to {} and {}.", curve.at.size(),
        predictor.emulator().runs().size(), (folder / "prediction.csv").string(),
        (folder / "figures" / "prediction.png").string()));
    note_left_out(curve, varied.points, console);
}

}  // namespace

int predict(const std::vector<std::string>& arguments) {
    Options options(
        "predict [options]",
        "Predicts steady shear, with standard errors, from the simulations that come with the "
        "program (the\n"
        "atlas) and those in the store, without a new simulation. Refuses a state that these "
        "simulations do\n"
        "not cover: outside of their convex hull, with a standard error above 15 % of the stress "
        "ratio or 2 %\n"
        "of the solid fraction, or with impossible values. With --along, writes a curve as CSV and "
        "figure, as\n"
        "far as the simulations reach.",
        "  pendular predict --friction 0.09\n"
        "  pendular predict --friction 0.09 --reduced-pressure 1 --liquid-content 0.03\n"
        "  pendular predict --reduced-pressure 3 --bridge-volume 0.004 --json -\n"
        "  pendular predict --friction 0.8 --simulate --fidelity quick\n"
        "  pendular predict --along reduced-pressure=0.5:50 --liquid-content 0.03 --out "
        "curve\n"
        "  pendular predict --along liquid-content=0.004:0.06 --reduced-pressure 3 --draw "
        "rumpf_cohesion --draw generalised_cohesion\n",
        false);
    options.set_out("folder for prediction.csv and the figure of --along (default: here)");
    options.leave_out({"threads"});
    RequestedState requested;
    double pressure = 0, volume = 0, content = 0, stiffness_number = 0;
    options.add("friction", &requested.friction,
                "friction coefficient between grains [1] (default 0.09)");
    options.add(
        "inertial-number", &requested.inertial_number,
        "shear rate times sqrt(m/(a s22)), with mass m and diameter a of a grain and normal "
        "stress s22 [1] (default 0, the quasi-static limit)");
    options.add("reduced-pressure", &pressure,
                "P* = a^2 s22/F0 of wet grains, with the pull-off force F0 of a liquid bridge [1] "
                "(default: dry)");
    options.add("bridge-volume", &volume,
                "volume of a liquid bridge over a^3, with the grain diameter a [1]");
    options.add("liquid-content", &content,
                "liquid volume over grain volume [1], instead of --bridge-volume");
    options.add(
        "stiffness-number", &stiffness_number,
        "(E/((1 - nu^2) s22))^(2/3), with Young's modulus E and Poisson ratio nu of the grains and "
        "the normal stress s22 [1] (default: the value that belongs to --fidelity)");
    std::string along;
    int points = 60;
    options.add("along", &along, "NAME=FROM:TO: quantity to vary, with its first and last value");
    options.add("points", &points, "number of states along the curve (default 60)");
    std::vector<std::string> drawn;
    options.add("draw", &drawn,
                "observable or formula to draw along the curve (default: stress_ratio and "
                "solid_fraction); may be repeated");
    bool simulate = false;
    options.add_switch(
        "simulate", &simulate,
        "if atlas and store do not cover the state, simulate it at the --fidelity, keep "
        "the result in the store and print the averages");
    options.offer_runs_of();
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
    if (along.empty() && !drawn.empty()) {
        throw InputError("--draw needs --along NAME=FROM:TO, the curve to draw");
    }
    for (auto name = drawn.begin(); name != drawn.end();) {  // each once
        name = std::find(drawn.begin(), name, *name) == name ? name + 1 : drawn.erase(name);
    }
    if (drawn.empty()) drawn = {"stress_ratio", "solid_fraction"};
    if (simulate && !along.empty()) {
        throw InputError(
            "--simulate answers for one state; with --along, 'pendular campaign' makes the "
            "simulations");
    }
    std::optional<VariedQuantity> line;
    if (!along.empty()) {
        line = VariedQuantity::parsed(along, points);
        for (const double end : {line->from, line->to}) {
            RequestedState at = requested;
            line->set(at, end);
            at.check_supported();
        }
    } else {
        requested.check_supported();
    }
    if (!options.given("stiffness-number")) {
        stiffness_number = common->fidelity.stiffness_number;
    }
    StatePredictor::check_stiffness_number(stiffness_number);
    Console console(*common);
    const auto store = open_store(*common);
    const auto training = training_runs(*common, store.get());
    const StatePredictor predictor(common->fidelity, store.get(), stiffness_number, training.get());
    if (line) {
        predict_along(requested, *line, drawn, predictor, *common, console);
    } else if (simulate && !predictor.supports(requested)) {
        simulate_one(requested, predictor, *common, store.get(), console);
    } else {
        predict_one(requested, predictor, simulate, console);
    }
    return done;
}

}  // namespace pendular::app
