// `pendular predict`: predicts a state of steady shear from earlier simulations.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>

#include "app/command.h"
#include "app/console.h"
#include "app/options.h"
#include "app/stored_runs.h"
#include "app/terminal.h"
#include "calib/emulator/emulated_observables.h"
#include "data/files/write_whole.h"
#include "data/input_error.h"
#include "reports/draw_figure.h"
#include "reports/run_report.h"
#include "reports/simulation_figures.h"
#include "sim/runs/ensemble.h"
#include "workflow/json/prediction.h"

namespace pendular::app {
namespace {

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
    console.print(simulated_output(requested, wanted, run, common.fidelity, store));
    console.json(simulated_state_json(wanted, run));
}

void predict_one(const RequestedState& requested, const StatePredictor& predictor, bool simulates,
                 Console& console) {
    const StatePrediction prediction = predictor.at(requested);
    console.print(prediction_output(requested, prediction, simulates));
    console.json(to_json(prediction, predictor.emulator().runs()));
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
    console.json(to_json(curve, predictor.emulator().runs()));  // before the figure
    draw(prediction_figure(curve, predictor.emulator(), drawn), folder / "figures");
    console.print(curve_output(curve, varied.points, predictor.emulator().runs().size(), folder));
}

const char* const about_predict =
    "Predicts steady shear, with standard errors, from the simulations that come with the "
    "program (the\n"
    "atlas) and those in the store, without a new simulation. Refuses a state that these "
    "simulations do\n"
    "not cover: outside of their convex hull, with a standard error above 15 % of the stress "
    "ratio or 2 %\n"
    "of the solid fraction, or with impossible values. With --along, writes a curve as CSV and "
    "figure, as\n"
    "far as the simulations reach.";

const char* const predict_examples =
    "  pendular predict --friction 0.09\n"
    "  pendular predict --friction 0.09 --reduced-pressure 1 --liquid-content 0.03\n"
    "  pendular predict --reduced-pressure 3 --bridge-volume 0.004 --json -\n"
    "  pendular predict --friction 0.8 --simulate --fidelity quick\n"
    "  pendular predict --along reduced-pressure=0.5:50 --liquid-content 0.03 --out "
    "curve\n"
    "  pendular predict --along liquid-content=0.004:0.06 --reduced-pressure 3 --draw "
    "rumpf_cohesion --draw generalised_cohesion\n";

/// Options of the command.
struct PredictOptions {
    RequestedState requested;
    double pressure = 0, volume = 0, content = 0, stiffness_number = 0;
    std::string along;
    int points = 60;
    std::vector<std::string> drawn;
    bool simulate = false;

    void declare(Options& options);
    /// Completes the options from those that were given, and returns the line of states of --along.
    /// @throws InputError where they do not go together
    std::optional<VariedQuantity> complete(const Options& options);
};

void PredictOptions::declare(Options& options) {
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
    options.add("along", &along, "NAME=FROM:TO: quantity to vary, with its first and last value");
    options.add("points", &points, "number of states along the curve (default 60)");
    options.add("draw", &drawn,
                "observable or formula to draw along the curve (default: stress_ratio and "
                "solid_fraction); may be repeated");
    options.add_switch(
        "simulate", &simulate,
        "if atlas and store do not cover the state, simulate it at the --fidelity, keep "
        "the result in the store and print the averages");
}

std::optional<VariedQuantity> PredictOptions::complete(const Options& options) {
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
    return line;
}

}  // namespace

int predict(const std::vector<std::string>& arguments) {
    Options options("predict [options]", about_predict, predict_examples, false);
    options.set_out("folder for prediction.csv and the figure of --along (default: here)");
    options.leave_out({"threads"});
    PredictOptions own;
    own.declare(options);
    options.offer_runs_of();
    const auto common = options.parse(arguments);
    if (!common) {
        return done;
    }
    const auto line = own.complete(options);
    if (!options.given("stiffness-number")) {
        own.stiffness_number = common->fidelity.stiffness_number;
    }
    StatePredictor::check_stiffness_number(own.stiffness_number);
    Console console(*common);
    const auto store = open_store(*common);
    const auto training = training_runs(*common, store.get());
    const StatePredictor predictor(common->fidelity, store.get(), own.stiffness_number,
                                   training.get());
    if (line) {
        predict_along(own.requested, *line, own.drawn, predictor, *common, console);
    } else if (own.simulate && !predictor.supports(own.requested)) {
        simulate_one(own.requested, predictor, *common, store.get(), console);
    } else {
        predict_one(own.requested, predictor, own.simulate, console);
    }
    return done;
}

}  // namespace pendular::app
