// `pendular runs`: lists, compares and maintains stored runs.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>

#include "app/command.h"
#include "app/console.h"
#include "app/options.h"
#include "app/stored_runs.h"
#include "app/terminal.h"
#include "calib/emulator/emulated_observables.h"
#include "calib/emulator/emulator.h"
#include "calib/emulator/emulator_hyperparameters.h"
#include "data/input_error.h"
#include "data/quantities/nearest.h"
#include "reports/draw_figure.h"
#include "reports/run_plots.h"
#include "sim/dem/grain_effects.h"
#include "sim/runs/run_request.h"
#include "sim/runs/store/run_table.h"
#include "workflow/json.h"

namespace pendular::app {
namespace {

using nlohmann::ordered_json;

/// Arguments of an action of `pendular runs`.
struct Request {
    CommonOptions common;
    std::vector<std::string> words;
    std::string condition, x = "inertial_number", y = "stress_ratio";
    bool atlas = false, yes = false;

    /// Runs of the store, or with --atlas of the atlas, for which the condition of --where holds.
    /// @throws InputError where the store or the atlas does not exist, and for a wrong condition
    std::vector<StoredRun> selected() const {
        if (!atlas) {
            return RunStore(common.store, true).select(condition);
        }
        const auto file = atlas_file();
        if (file.empty()) {
            throw InputError("there is no atlas; name one in PENDULAR_ATLAS");
        }
        RunStore store(RunStore::in_memory);
        for (const StoredRun& run : read_runs(file)) {
            store.add(run.run, run.physics_version);
        }
        return store.select(condition);
    }
};

void demand_words(const Request& request, std::size_t least, const std::string& what) {
    if (request.words.size() < least) {
        throw InputError("name " + what);
    }
}

std::string wetness(const dem::RunParameters& p) {
    return p.wetting ? fmt::format("{:>6.3g} {:>8.3g}", p.wetting->reduced_pressure,
                                   p.wetting->bridge_volume)
                     : fmt::format("{:>6} {:>8}", "dry", "");
}

std::string flags(const dem::RunResult& run) {
    std::vector<std::string> words;
    const auto flag = [&](bool holds, const char* word) {
        if (holds) {
            words.emplace_back(word);
        }
    };
    if (!run.failure.empty()) {
        return "failed";
    }
    flag(run.crystallised, "crystallised");
    flag(!run.steady, "not steady");
    flag(run[dem::Observable::localization].value > dem::localised_above, "localised");
    return fmt::format("{}", fmt::join(words, ", "));
}

/// Text of the effects of a run, preceded by `before`; empty for a run without effects.
std::string with_effects(const dem::RunParameters& p, const std::string& before) {
    return p.effects.empty() ? "" : before + effects_text(p.effects);
}

ordered_json stored_json(const StoredRun& stored) {
    ordered_json json = {{"id", stored.id}, {"physics_version", stored.physics_version}};
    json.update(pendular::to_json(stored.run));
    if (!stored.run.failure.empty()) {
        json["failure"] = stored.run.failure;
    }
    return json;
}

int list(const Request& request, Console& console) {
    const auto runs = request.selected();
    const bool effects = std::ranges::any_of(
        runs, [](const StoredRun& stored) { return !stored.run.parameters.effects.empty(); });
    console.answer(fmt::format("{} run{}.", runs.size(), runs.size() == 1 ? "" : "s"));
    console.line(
        fmt::format("   id friction     I      P*  V0/a^3  kappa beads strain  stress ratio        "
                    "solid fraction{}",
                    effects ? "      remarks, effects (in the units of the simulation)" : ""));
    for (const auto& [id, version, run] : runs) {
        const auto& p = run.parameters;
        const Mean &ratio = run[dem::Observable::stress_ratio],
                   &solid = run[dem::Observable::solid_fraction];
        console.line(fmt::format(
            "{:>5} {:>8.4g} {:>6.3g} {} {:>6.4g} {:>5} {:>6.3g}  {:<18}  {:<18} {}{}", id,
            p.friction, p.inertial_number, wetness(p), p.stiffness_number, p.grains, p.strain,
            run.failure.empty() ? with_error(ratio.value, ratio.standard_error) : "",
            run.failure.empty() ? with_error(solid.value, solid.standard_error) : "", flags(run),
            with_effects(p, flags(run).empty() ? "" : "; ")));
    }
    ordered_json json = ordered_json::array();
    for (const StoredRun& run : runs) {
        json.push_back(stored_json(run));
    }
    console.json({{"runs", json}});
    return done;
}

int show(const Request& request, Console& console) {
    demand_words(request, 1, "a run: pendular runs show 12");
    const RunStore store(request.common.store, true);
    ordered_json json = ordered_json::array();
    for (const std::string& word : request.words) {
        const StoredRun stored = store.get(run_number(word));
        json.push_back(stored_json(stored));
        console.line(fmt::format("run {}\n{}", stored.id,
                                 run_description(stored.run.parameters, stored.run.threads)));
        for (std::size_t k = 0; k < dem::observable_count; ++k) {
            const auto which = static_cast<dem::Observable>(k);
            if (stored.run.parameters.wetting || !dem::needs_bridges(which)) {
                const Mean& mean = stored.run[which];
                console.line(fmt::format("  {:<32} {}", dem::observable_names[k],
                                         with_error(mean.value, mean.standard_error)));
            }
        }
        if (const std::string words = flags(stored.run); !words.empty()) {
            console.note(words + (stored.run.failure.empty() ? "" : ": " + stored.run.failure));
        }
        if (request.common.out && !stored.run.trace.empty()) {
            draw(trace_figure(stored), *request.common.out / "figures");
        }
    }
    console.json({{"runs", json}});
    return done;
}

int compare_two(const Request& request, Console& console) {
    demand_words(request, 2, "two runs: pendular runs compare 12 15");
    const RunStore store(request.common.store, true);
    const StoredRun first = store.get(run_number(request.words[0])),
                    second = store.get(run_number(request.words[1]));
    console.line(fmt::format("{:<32} {:>20} {:>20} {:>26}", "", fmt::format("run {}", first.id),
                             fmt::format("run {}", second.id), "difference / standard error"));
    for (const StoredRun* stored : {&first, &second}) {
        if (!stored->run.parameters.effects.empty()) {
            console.line(with_effects(stored->run.parameters,
                                      fmt::format("run {} has the effects ", stored->id)));
        }
    }
    ordered_json json = {{"first", first.id}, {"second", second.id}};
    for (std::size_t k = 0; k < dem::observable_count; ++k) {
        const auto which = static_cast<dem::Observable>(k);
        const bool wet = first.run.parameters.wetting && second.run.parameters.wetting;
        if (!wet && dem::needs_bridges(which)) {
            continue;
        }
        const Mean &a = first.run[which], &b = second.run[which];
        const double error = std::hypot(a.standard_error, b.standard_error),
                     z = error > 0 ? (b.value - a.value) / error : 0;
        const std::string name(dem::observable_names[k]);
        console.line(fmt::format("{:<32} {:>20} {:>20} {:>26.1f}", name,
                                 with_error(a.value, a.standard_error),
                                 with_error(b.value, b.standard_error), z));
        json["observables"][name] = {
            {"difference", {{"value", b.value - a.value}, {"stderr", error}}}, {"standardised", z}};
    }
    console.json(json);
    return done;
}

int plot(const Request& request, Console& console) {
    const auto folder = request.common.out.value_or(".");
    const auto runs = request.selected();
    const Figure figure = runs_figure(runs, request.x, request.y);
    draw(figure, folder);
    console.line(fmt::format("{} runs are drawn in {}", runs.size(),
                             (folder / figure.name).string() + ".png"));
    return done;
}

int export_runs(const Request& request, Console& console) {
    demand_words(request, 1, "the file to write: pendular runs export runs.csv");
    demand_writable(request.words[0], "export", false);
    demand_table(request.words[0], "physics_version,");
    const auto runs = request.selected();
    write_runs(request.words[0], runs);
    console.line(fmt::format("{} runs are written to {}.", runs.size(), request.words[0]));
    return done;
}

/// Adds runs to the store by calling `take` for each file among the words; `take` returns the
/// number of runs that it added.
/// @throws InputError without a file, with `what` to name, and for a file that does not exist
int take_in(const Request& request, Console& console, const std::string& what,
            const std::function<std::size_t(RunStore&, const std::string&)>& take) {
    demand_words(request, 1, what);
    for (const std::string& file : request.words) {
        if (std::error_code error; !std::filesystem::exists(file, error)) {
            // Checked first, so that a missing file creates no empty store.
            throw InputError(file + ": no such file");
        }
    }
    RunStore store(request.common.store);
    std::size_t added = 0;
    for (const std::string& file : request.words) {
        added += take(store, file);
    }
    console.line(fmt::format("{} runs added to {}, which now holds {} runs.", added,
                             store.file().string(), store.size()));
    console.json({{"added", added}, {"runs", store.size()}});
    return done;
}

int import_runs(const Request& request, Console& console) {
    // Read before the store is opened, so that a wrong table makes no store.
    std::map<std::string, std::vector<StoredRun>> tables;
    for (const std::string& file : request.words) {
        std::error_code error;
        if (std::filesystem::exists(file, error)) tables[file] = read_runs(file);
    }
    const auto add = [&](RunStore& store, const std::string& file) {
        std::size_t added = 0;
        for (const StoredRun& run : tables[file]) {
            added += store.add(run.run, run.physics_version);
        }
        return added;
    };
    return take_in(request, console, "the file to read: pendular runs import runs.csv", add);
}

int merge(const Request& request, Console& console) {
    return take_in(
        request, console, "the stores to add: pendular runs merge part-*.sqlite",
        [](RunStore& store, const std::string& file) { return store.merge(RunStore(file, true)); });
}

int prune(const Request& request, Console& console) {
    if (request.condition.empty()) {
        throw InputError(
            "name what to remove: pendular runs prune --where \"failure IS NOT NULL\" --yes");
    }
    RunStore store(request.common.store, true);
    const std::vector<std::int64_t> ids = store.numbers(request.condition);
    if (!request.yes) {
        console.line(fmt::format("{} of {} runs would be removed. Add --yes to remove them.",
                                 ids.size(), store.size()));
        return done;
    }
    const std::size_t removed = store.remove(ids);
    console.line(fmt::format("{} runs removed, {} left.", removed, store.size()));
    return done;
}

/// Fits the hyperparameters of the emulator to the selected runs and writes them to a CSV file.
int learn(const Request& request, Console& console) {
    demand_words(request, 1, "the file to write, emulator.csv beside its atlas");
    demand_table(request.words[0], "observable,");
    std::vector<dem::RunResult> runs;
    for (const StoredRun& stored : request.selected()) {
        if (emulated::usable(stored.run)) {
            runs.push_back(stored.run);
        }
    }
    if (runs.empty()) {
        throw InputError(
            "none of these runs can train the emulator: it needs runs that are steady, sheared "
            "uniformly and did not crystallise");
    }
    EmulatorHyperparameters hyperparameters;
    for (const dem::Observable which : emulated::observables()) {
        if (PlainEmulator::known(runs, which)) {
            hyperparameters[which] = PlainEmulator::learn(runs, which);
        }
        if (!request.common.quiet) {
            print_line(stderr, fmt::format("Hyperparameters fitted for {} of {} observables.",
                                           hyperparameters.size(), emulated::observables().size()));
        }
    }
    write_hyperparameters(request.words[0], hyperparameters);
    console.line(
        fmt::format("Hyperparameters of {} observables, fitted from {} runs, are written to {}.",
                    hyperparameters.size(), runs.size(), request.words[0]));
    return done;
}

const std::vector<std::pair<std::string, int (*)(const Request&, Console&)>> actions = {
    {"list", list},   {"show", show},          {"compare", compare_two},
    {"plot", plot},   {"export", export_runs}, {"import", import_runs},
    {"merge", merge}, {"prune", prune},        {"learn", learn}};

}  // namespace

int runs(const std::vector<std::string>& arguments) {
    Request request;
    Options options(
        "runs list|show|compare|plot|export|import|merge|prune|learn [arguments] [options]",
        "Lists, shows, compares, draws, exports, adds and removes stored simulations (runs).\n"
        "  list              one line per run\n"
        "  show ID...        one run in full; with --out, a figure of its time series\n"
        "  compare ID ID     two runs side by side\n"
        "  plot              a figure of one column against another, in the folder --out\n"
        "  export FILE.csv   write the runs as a table\n"
        "  import FILE.csv   add the runs of such a table\n"
        "  merge STORE...    add the runs of other stores\n"
        "  prune             remove the runs that --where selects\n"
        "  learn FILE.csv    fit the emulator's hyperparameters; other commands use them from "
        "emulator.csv\n                    beside the atlas",
        "  pendular runs list --where \"friction = 0.09 AND reduced_pressure IS NULL\"\n"
        "  pendular runs list --atlas\n"
        "  pendular runs list --where \"effects IS NULL\"\n"
        "  pendular runs learn --atlas sim/atlas/emulator.csv\n"
        "  pendular runs plot --x inertial_number --y solid_fraction --out figures\n"
        "  pendular runs prune --where \"crystallised\" --yes\n",
        false);
    options.take(&request.words, one_of({"list", "show", "compare", "plot", "export", "import",
                                         "merge", "prune", "learn"}));
    options.set_out("folder for figures (default: here)");
    options.add("where", &request.condition,
                "only runs for which this SQL condition on the columns holds");
    options.add("x", &request.x, "column on the x axis of the plot (default inertial_number)");
    options.add("y", &request.y, "column on the y axis of the plot (default stress_ratio)");
    options.add_switch("atlas", &request.atlas,
                       "use the runs that come with pendular in place of the store");
    options.add_switch("yes", &request.yes, "remove without asking");
    const auto common = options.parse(arguments);
    if (!common) {
        return done;
    }
    request.common = *common;
    std::vector<std::string> names;
    for (const auto& [name, run] : actions) {
        if (!request.words.empty() && request.words.front() == name) {
            request.words.erase(request.words.begin());
            Console console(request.common);
            return run(request, console);
        }
        names.push_back(name);
    }
    throw InputError(request.words.empty()
                         ? "the action is missing; use list, show, compare, plot, export, import, "
                           "merge, prune or learn"
                         : fmt::format("unknown action '{}'; {}", request.words.front(),
                                       did_you_mean(request.words.front(), names)));
}

}  // namespace pendular::app
