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
#include "calib/emulator/known_runs.h"
#include "data/input_error.h"
#include "reports/draw_figure.h"
#include "reports/run_report.h"
#include "reports/simulation_figures.h"
#include "sim/runs/run_request.h"
#include "sim/runs/store/run_table.h"
#include "workflow/json/commands.h"
#include "workflow/json/run.h"

namespace pendular::app {
namespace {

int list(const RunsRequest& request, Console& console) {
    const auto runs = request.selected();
    console.print(runs_output(runs));
    console.json(to_json(runs));
    return done;
}

int show(const RunsRequest& request, Console& console) {
    request.demand_words(1, "a run: pendular runs show 12");
    const auto store = request.source();
    std::vector<StoredRun> shown;
    for (const std::string& word : request.words) {
        const StoredRun& stored = shown.emplace_back(numbered_run(*store, word));
        console.print(run_output(stored));
        if (request.common.out && !stored.run.trace.empty()) {
            draw(trace_figure(stored), *request.common.out / "figures");
        }
    }
    console.json(to_json(shown));
    return done;
}

int compare_two(const RunsRequest& request, Console& console) {
    request.demand_words(2, "two runs: pendular runs compare 12 15");
    const auto store = request.source();
    const StoredRun first = numbered_run(*store, request.words[0]),
                    second = numbered_run(*store, request.words[1]);
    console.print(difference_output(first, second));
    console.json(differences_json(first, second));
    return done;
}

int plot(const RunsRequest& request, Console& console) {
    const auto folder = request.common.out.value_or(".");
    const auto runs = request.selected();
    const Figure figure = runs_figure(runs, request.x, request.y);
    draw(figure, folder);
    console.line(fmt::format("{} runs are drawn in {}", runs.size(),
                             (folder / figure.name).string() + ".png"));
    return done;
}

int export_runs(const RunsRequest& request, Console& console) {
    request.demand_words(1, "the file to write: pendular runs export runs.csv");
    demand_writable(request.words[0], "export", false);
    demand_table(request.words[0], "physics_version,");
    const auto runs = request.selected();
    write_runs(request.words[0], runs);
    console.line(fmt::format("{} runs are written to {}.", runs.size(), request.words[0]));
    return done;
}

/// Adds runs to the store by calling `take` for each file among the words; `take` returns the
/// number of runs that it added.
/// @throws InputError with --atlas, without a file (with `what` to name), and for a file that does
///         not exist
int take_in(const RunsRequest& request, Console& console, const std::string& action,
            const std::string& what,
            const std::function<std::size_t(RunStore&, const std::string&)>& take) {
    request.refuse_atlas(action);
    request.demand_words(1, what);
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
    console.json(added_json(added, store.size()));
    return done;
}

int import_runs(const RunsRequest& request, Console& console) {
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
    return take_in(request, console, "import", "the file to read: pendular runs import runs.csv",
                   add);
}

int merge(const RunsRequest& request, Console& console) {
    return take_in(
        request, console, "merge", "the stores to add: pendular runs merge part-*.sqlite",
        [](RunStore& store, const std::string& file) { return store.merge(RunStore(file, true)); });
}

int prune(const RunsRequest& request, Console& console) {
    request.refuse_atlas("prune");
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
int learn(const RunsRequest& request, Console& console) {
    request.demand_words(1, "the file to write, emulator.csv beside its atlas");
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

const std::vector<std::pair<std::string, int (*)(const RunsRequest&, Console&)>> actions = {
    {"list", list},   {"show", show},          {"compare", compare_two},
    {"plot", plot},   {"export", export_runs}, {"import", import_runs},
    {"merge", merge}, {"prune", prune},        {"learn", learn}};

const char* const about_runs =
    "Lists, shows, compares, draws, exports, adds and removes stored simulations (runs). The "
    "columns for\n"
    "--where, --x and --y are those of the table that 'export' writes.\n"
    "  list              print one line per simulation\n"
    "  show ID...        print all data of the simulations; with --out, also draw their time "
    "series\n"
    "  compare ID ID     print two simulations side by side\n"
    "  plot              draw one column against another; the figure is put into the folder "
    "--out\n"
    "  export FILE.csv   write the simulations as a table\n"
    "  import FILE.csv   add to the store the simulations of a table that 'export' wrote\n"
    "  merge STORE...    add to the store the simulations of other stores\n"
    "  prune             remove from the store the simulations that match --where\n"
    "  learn FILE.csv    fit the hyperparameters of the emulator (for developers of Pendular)";

const char* const runs_examples =
    "  pendular runs list --where \"friction = 0.09 AND reduced_pressure IS NULL\"\n"
    "  pendular runs list --atlas\n"
    "  pendular runs compare 1 2 --atlas\n"
    "  pendular runs list --where \"effects IS NULL\"\n"
    "  pendular runs learn --atlas sim/atlas/emulator.csv\n"
    "  pendular runs plot --x inertial_number --y solid_fraction --out figures\n"
    "  pendular runs prune --where \"crystallised\" --yes\n";

}  // namespace

int runs(const std::vector<std::string>& arguments) {
    RunsRequest request;
    Options options(
        "runs list|show|compare|plot|export|import|merge|prune|learn [arguments] [options]",
        about_runs, runs_examples, false);
    options.take(&request.words, one_of({"list", "show", "compare", "plot", "export", "import",
                                         "merge", "prune", "learn"}));
    options.set_out("folder for figures (default: here)");
    options.add("where", &request.condition,
                "only simulations for which this SQL condition on the columns holds");
    options.add("x", &request.x, "column on the x axis of the plot (default inertial_number)");
    options.add("y", &request.y, "column on the y axis of the plot (default stress_ratio)");
    options.add_switch(
        "atlas", &request.atlas,
        "use the simulations that come with pendular (the atlas) instead of the store");
    options.add_switch(
        "yes", &request.yes,
        "with prune: remove the simulations; without it, only their number is printed");
    options.leave_out({"fidelity", "threads"});
    options.set_store(
        "SQLite file with the simulations (default: $PENDULAR_STORE, else "
        "~/.local/share/pendular/runs.sqlite)");
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
