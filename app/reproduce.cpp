// `pendular reproduce`: the numbers and figures of Badetti et al. (2018) beside the simulations.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/command.h"
#include "app/console.h"
#include "app/options.h"
#include "app/stored_runs.h"
#include "app/terminal.h"
#include "data/files/write_whole.h"
#include "data/input_error.h"
#include "reports/run_report.h"
#include "reports/simulation_figures.h"
#include "sim/runs/ensemble.h"
#include "workflow/json/prediction.h"

namespace pendular::app {
namespace {

const char* const about_reproduce =
    R"(Compares the simulations with every number of Badetti et al. (2018), Shear strength of wet
granular materials, and draws each figure of that article that shows simulations. Uses the simulations
that come with the program (the atlas) and those in the store. Prints the numbers that disagree (with
--all every number); with --out, writes reproduction.md and the figures.)";

/// Simulates the states of the paper's study that no earlier run simulates, and keeps the runs.
void simulate_missing(const Reproduction& reproduction, const CommonOptions& common,
                      RunStore* store, Console& console) {
    const std::vector<dem::RunParameters> runs = reproduction.missing_runs();
    if (runs.empty()) return;
    const InterruptGuard guard;
    run_all(runs,
            {.threads = common.threads,
             .stop = guard.token(),
             .report = [&](const EnsembleProgress& at) { console.progress("Simulations", at); },
             .store = store});
    console.end_progress();
}

}  // namespace

int reproduce(const std::vector<std::string>& arguments) {
    Options options("reproduce [options]", about_reproduce,
                    "  pendular reproduce\n"
                    "  pendular reproduce --all --json -\n"
                    "  pendular reproduce --out paper\n"
                    "  pendular reproduce --simulate --fidelity paper --out paper\n",
                    false);
    options.set_out("folder for reproduction.md and the figures (default: none are written)");
    bool simulate = false;
    options.add_switch(
        "simulate", &simulate,
        "simulate the states of the article that neither atlas nor store has, at the --fidelity, "
        "and keep the results in the store");
    const auto common = options.parse(arguments);
    if (!common) {
        return done;
    }
    Console console(*common);
    const auto store = open_store(*common);
    if (simulate) {
        if (store == nullptr) {
            throw InputError("--simulate: the store cannot be written; name one with --store FILE");
        }
        simulate_missing(Reproduction(common->fidelity, store.get()), *common, store.get(),
                         console);
    }
    const Reproduction reproduction(common->fidelity, store.get());
    console.print(reproduction_output(reproduction, common->all));
    if (common->out) {
        write_whole(*common->out / "reproduction.md", reproduction_page(reproduction));
        console.figures(*common->out / "figures", paper_figures(reproduction.study()));
    } else {
        console.next("pendular reproduce --out paper   # writes reproduction.md and the figures");
    }
    console.json(to_json(reproduction));
    return done;
}

}  // namespace pendular::app
