#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "app/command.h"
#include "app/console.h"
#include "app/options.h"
#include "app/run_effects.h"
#include "app/stored_runs.h"
#include "app/terminal.h"
#include "data/files/write_whole.h"
#include "data/input_error.h"
#include "reports/draw_figure.h"
#include "reports/figure.h"
#include "reports/run_report.h"
#include "reports/simulation_figures.h"
#include "sim/dem/checkpoint.h"
#include "sim/dem/run.h"
#include "sim/dem/series.h"
#include "sim/dem/snapshot.h"
#include "sim/runs/run_request.h"
#include "workflow/json/parts.h"
#include "workflow/json/run.h"
#include "workflow/state_prediction.h"

namespace pendular::app {
namespace {

/// Requested standard error of an observable, parsed from "OBSERVABLE=STANDARD_ERROR".
/// @throws InputError for a malformed text or an unknown observable
dem::Precision precision_from(const std::string& text) {
    try {
        return dem::precision_named(text);
    } catch (const std::invalid_argument& error) {
        throw InputError(fmt::format("--precision {}: {}", text, error.what()));
    }
}

/// Checks that a run can be simulated.
/// @throws InputError where it cannot
void refuse_impossible(const dem::RunParameters& run) {
    try {
        check_run(run);
    } catch (const std::invalid_argument& error) {
        throw InputError(error.what());
    }
}

/// Options for snapshots, checkpoints and the initial state of a run.
struct Extras {
    double snapshot_every = 0;       ///< strain between snapshots [1]; 0: no snapshots
    std::string checkpoint;          ///< file for checkpoints; empty: none
    double checkpoint_minutes = 10;  ///< time between checkpoints [min]
    std::string start;  ///< number of the stored run to start from, or "nearest"; empty: none

    void declare(Options& options);
    /// Checks that these options go together with each other and with the common options.
    /// @throws InputError where they do not
    void check_combination(const Options& options, const CommonOptions& common) const;
};

void Extras::declare(Options& options) {
    options.add("start", &start,
                "number of the stored simulation ('pendular runs list') whose final state is the "
                "initial state, or 'nearest': the stored simulation with the nearest parameters (a "
                "random state if there is none); shortens the transient");
    options.add("snapshot-every", &snapshot_every,
                "strain between snapshots for OVITO and ParaView in the folder of --out [1]");
    options.add("checkpoint", &checkpoint,
                "file for the state of the running simulation; the same command resumes it",
                a_file());
    options.add("checkpoint-every", &checkpoint_minutes,
                "time between checkpoints [min] (default 10)");
}

void Extras::check_combination(const Options& options, const CommonOptions& common) const {
    if (options.given("snapshot-every")) {
        if (!common.out) {
            throw InputError("--snapshot-every needs --out DIR, the folder for the snapshots");
        }
        if (!(snapshot_every >= dem::block_strain)) {
            throw InputError(fmt::format("--snapshot-every {}: a strain of {} or more is needed",
                                         snapshot_every, dem::block_strain));
        }
    }
    if (options.given("checkpoint")) {
        demand_writable(checkpoint, "--checkpoint", false);
    } else if (options.given("checkpoint-every")) {
        throw InputError("--checkpoint-every needs --checkpoint FILE");
    }
    if (options.given("start") && options.given("seed")) {
        throw InputError(
            "--start takes its initial state from a stored simulation, so that there is no --seed "
            "to set");
    }
    if (!(checkpoint_minutes > 0)) {
        throw InputError(
            fmt::format("--checkpoint-every {}: minutes above 0 are needed", checkpoint_minutes));
    }
}

/// Prints the progress of a single run. The time left follows from the speed since this object was
/// made, so that it is right for a resumed run too.
class RunProgress {
  public:
    explicit RunProgress(Console& console) : console_(console) {}

    void operator()(double done, double expected) {
        const double fraction = std::min(0.999, done / expected);
        if (!first_) {
            first_ = fraction;
        }
        const double spent =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - started_).count();
        const double gained = fraction - *first_;
        console_.progress("simulating",
                          {.runs = 1,
                           .fraction = fraction,
                           .seconds_left = gained > 0 ? spent * (1 - fraction) / gained : 0});
    }

  private:
    Console& console_;
    std::optional<double> first_;
    std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
};

void write_fields(const dem::RunResult& result, const nlohmann::ordered_json& json,
                  const std::filesystem::path& folder) {
    write_json(folder / "run.json", json);
    for (const auto& [name, content] : field_tables(result)) {
        write_whole(folder / name, content);
    }
    for (const auto& figure : field_figures(result)) {
        draw(figure, folder / "figures");
    }
}

/// Text on the files that an interrupted run has written and on how to resume the run.
std::string what_remains(const dem::Checkpoint* checkpoint, const dem::Snapshots* snapshots) {
    std::string text;
    if (snapshots) {
        text = fmt::format("{} snapshots so far are written", snapshots->count());
    }
    if (checkpoint) {
        text += fmt::format("{}give the same command again to resume from {}",
                            text.empty() ? "" : "; ", checkpoint->file().string());
    }
    return text.empty() ? "nothing was written" : text;
}

/// Stored run to start from: the run with the number `word`, or for "nearest" the run with the
/// nearest state, if there is one.
/// @throws InputError where there is no run of this number, or the run has no final state
std::optional<StoredRun> start_of(const dem::RunParameters& run, const std::string& word,
                                  const RunStore& store) {
    if (word != "nearest") {
        StoredRun stored = store.get(run_number(word));
        if (stored.run.final_state.grains.empty()) {
            throw InputError(
                fmt::format("--start {}: this stored simulation has no final state to start from; "
                            "one that failed or has grains of several sizes has none",
                            word));
        }
        return stored;
    }
    return store.nearest(run);
}

dem::RunResult shear(const dem::RunParameters& run, const dem::StoredSample* start,
                     dem::Checkpoint* checkpoint, dem::Snapshots* snapshots,
                     const CommonOptions& common, Console& console) {
    const InterruptGuard guard;
    dem::RunOptions options{.stop = guard.token(),
                            .progress = RunProgress(console),
                            .threads = common.threads,
                            .start = start,
                            .checkpoint = checkpoint};
    if (snapshots) {
        options.observers.emplace_back(std::ref(*snapshots));
    }
    if (checkpoint && checkpoint->exists() && !common.quiet) {
        options.observers.push_back(
            [&, told = false](const dem::ShearCell&, double strain) mutable {
                if (!std::exchange(told, true)) {
                    print_line(stderr, fmt::format("Resumed at strain {:.2f} from {}.", strain,
                                                   checkpoint->file().string()));
                }
            });
    }
    try {
        return pendular::simulate(run, options);
    } catch (const std::invalid_argument& error) {
        throw InputError(error.what());
    } catch (const dem::Interrupted&) {
        console.end_progress();
        throw dem::Interrupted(what_remains(checkpoint, snapshots));
    }
}

/// Computes, prints and returns the closures for a simulation. They need the stress ratio of dry
/// grains, which is predicted from earlier simulations; if that is impossible, a sentence says so.
/// Empty in that case, and for dry grains.
/// @param store null: only the atlas is used
std::optional<closures::ClosureValues> print_closures_of(const dem::RunResult& run,
                                                         const CommonOptions& common,
                                                         const RunStore* store, Console& console) {
    if (!run.parameters.wetting) return {};
    std::optional<closures::ClosureValues> values;
    try {
        values = StatePredictor(common.fidelity, store, run.parameters.stiffness_number)
                     .closures_of(run);
    } catch (const InputError&) {
        // No earlier runs predict the stress ratio of dry grains: the output says so.
    }
    console.print(closures_output(values, run[dem::Observable::stress_ratio].value));
    return values;
}

void simulate_and_report(dem::RunParameters run, const RunEffects& effects, const Extras& extras,
                         const CommonOptions& common, Console& console) {
    std::optional<dem::Checkpoint> checkpoint;
    if (!extras.checkpoint.empty()) {
        checkpoint.emplace(extras.checkpoint,
                           std::chrono::duration<double>(60 * extras.checkpoint_minutes));
    }
    std::optional<dem::Snapshots> snapshots;
    if (extras.snapshot_every > 0) {
        snapshots.emplace(*common.out, extras.snapshot_every);
    }
    const auto store = open_store(common);
    std::optional<StoredRun> start;
    if (!extras.start.empty()) {
        if (!store) {
            throw InputError("--start needs a store: name one with --store FILE");
        }
        start = start_of(run, extras.start, *store);
        if (start) {
            run.start = fingerprint(run_description(start->run.parameters, start->run.threads));
        } else {
            console.note(
                fmt::format("The simulation starts from a random sample: {} holds no steady {} "
                            "simulation of {} grains with its final state.",
                            store->file().string(), run.wetting ? "wet" : "dry", run.grains));
        }
    }
    const dem::RunResult result =
        shear(run, start ? &start->run.final_state : nullptr, checkpoint ? &*checkpoint : nullptr,
              snapshots ? &*snapshots : nullptr, common, console);
    if (store) {
        store->add(result);
    }
    Simulated simulated = effects.simulated(result, common.threads);
    console.print(simulation_output(simulated));
    simulated.closures = print_closures_of(result, common, store.get(), console);
    if (start) {
        console.line(fmt::format(
            "The simulation started from the final state of stored run {}: friction {:.4g}, "
            "inertial number {:.4g}.",
            start->id, start->run.parameters.friction, start->run.parameters.inertial_number));
    }
    const auto json = to_json(simulated);
    console.json(json);
    if (common.out) {
        write_fields(result, json, *common.out);
    }
    if (checkpoint) {
        checkpoint->remove();  // only after the results are written
    }
}

const char* const about_simulate =
    "Simulates a sample of equal grains, dry or joined by liquid bridges, that is sheared at "
    "constant\n"
    "normal stress until the flow is steady, and prints time averages with standard errors. "
    "The results\n"
    "hold for the simulated stiffness number, without correction. Options --EFFECT.PARAMETER "
    "add physical\n"
    "effects.";

std::string simulate_examples() {
    return "  pendular simulate --friction 0.09 --inertial-number 0.003\n"
           "  pendular simulate --reduced-pressure 3 --bridge-volume 0.002\n"
           "  pendular simulate --fidelity quick --friction 0.3 --json run.json\n"
           "  pendular simulate --strain 40 --precision stress_ratio=0.003\n"
           "  pendular simulate --fidelity quick --out run --snapshot-every 0.1\n"
           "  pendular simulate --fidelity paper --checkpoint run.checkpoint --threads 4\n"
           "  pendular simulate --normal-stress \"3 kPa\" " +
           example_of_run() + "\n";
}

/// Options for the state to simulate.
struct StateOptions {
    dem::RunParameters run;
    std::vector<std::string> precisions;
    dem::Wetting wetting{.bridge_volume = 2e-3};
    std::string bridge_force = to_string(FormulaVariant::derived);
    std::int64_t seed = 1;

    void declare(Options& options);
    /// Returns the parameters of the run, those that were not given from the fidelity.
    /// @throws InputError where the options do not go together
    dem::RunParameters complete(const Options& options, const CommonOptions& common);
};

void StateOptions::declare(Options& options) {
    options.add("friction", &run.friction,
                "friction coefficient between grains [1] (default 0.09)");
    options.add(
        "inertial-number", &run.inertial_number,
        "shear rate times sqrt(m/(a s22)), with mass m and diameter a of a grain and normal "
        "stress s22 [1] (default: the lowest that belongs to --fidelity)");
    options.add("stiffness-number", &run.stiffness_number,
                "(E/((1 - nu^2) s22))^(2/3) with Young's modulus E, Poisson ratio nu and normal "
                "stress s22 [1] (default: the value that belongs to --fidelity)");
    options.add("poisson-ratio", &run.poisson_ratio,
                "Poisson ratio of the grains [1] (default 0.3)");
    options.add("damping", &run.damping,
                "viscous damping of a contact along its normal, divided by the critical damping "
                "[1] (default 0.98)");
    options.add("beads", &run.grains,
                "number of grains (default: the number that belongs to --fidelity)");
    options.add("strain", &run.strain,
                "shear strain over which averages are taken, after the transient [1] (default: the "
                "value that belongs to --fidelity)");
    options.add("precision", &precisions,
                "OBSERVABLE=STANDARD_ERROR: averaging stops at this standard error, even before "
                "--strain is reached; may be repeated");
    options.add("reduced-pressure", &wetting.reduced_pressure,
                "P* = a^2 s22/F0 of wet grains, with the pull-off force F0 of a liquid bridge [1] "
                "(default: dry)");
    options.add(
        "bridge-volume", &wetting.bridge_volume,
        "volume of a liquid bridge, divided by a^3 (a: grain diameter) [1] (default 0.002)");
    options.add("bridge-force", &bridge_force,
                "force of a bridge between grains that do not touch: derived (default), or "
                "as_printed in Badetti et al. (2018), Eq. (5), which has half the liquid volume",
                one_of({"derived", "as_printed"}));
    options.add("seed", &seed, "seed of the random initial state (default 1)");
}

dem::RunParameters StateOptions::complete(const Options& options, const CommonOptions& common) {
    const auto& f = common.fidelity;
    run.seed = checked_seed(seed);
    wetting.bridge_force = formula_variant_named(bridge_force);
    if (options.given("reduced-pressure")) {
        run.wetting = wetting;
    } else if (options.given("bridge-volume") || options.given("bridge-force")) {
        throw InputError(
            "--bridge-volume and --bridge-force need --reduced-pressure: without it the grains are "
            "dry");
    }
    run.inertial_number =
        options.given("inertial-number") ? run.inertial_number : f.lowest_inertial_number;
    run.stiffness_number =
        options.given("stiffness-number") ? run.stiffness_number : f.stiffness_number;
    run.grains = options.given("beads") ? run.grains : f.grains;
    run.strain = options.given("strain") ? run.strain : f.strain;
    for (const auto& text : precisions) {
        run.precision.push_back(precision_from(text));
    }
    return run;
}

}  // namespace

int simulate(const std::vector<std::string>& arguments) {
    Options options("simulate [options]", about_simulate, simulate_examples(), false);
    options.set_threads(
        1, "threads of this simulation; equal numbers of threads give identical results");
    options.set_out(
        "folder for run.json, profiles and distributions as CSV and figures, and snapshots "
        "(default: no files)");
    StateOptions state;
    state.declare(options);
    Extras extras;
    extras.declare(options);
    RunEffects effects(options, arguments);
    const auto common = options.parse(arguments);
    if (!common) {
        return done;
    }
    dem::RunParameters run = state.complete(options, *common);
    refuse_impossible(run);
    run = effects.changed(run, options);
    refuse_impossible(run);
    extras.check_combination(options, *common);

    Console console(*common);
    simulate_and_report(run, effects, extras, *common, console);
    return done;
}

}  // namespace pendular::app
