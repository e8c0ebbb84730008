#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/command.h"
#include "app/console.h"
#include "app/effect_options.h"
#include "app/lab_options.h"
#include "app/options.h"
#include "app/terminal.h"
#include "data/files/json_text.h"
#include "data/files/write_whole.h"
#include "data/input_error.h"
#include "data/remarks/wording.h"
#include "reports/run_report.h"
#include "sim/lab/lab_checks.h"
#include "sim/lab/virtual_lab.h"
#include "sim/lab/virtual_study.h"
#include "sim/runs/store/run_store.h"
#include "workflow/json/run.h"

namespace pendular::app {
namespace {

/// Checks that a folder is new or empty, so that no earlier measurement is lost or mixed up.
/// @throws InputError where it holds files or cannot be written
void demand_new(const std::filesystem::path& folder) {
    demand_writable(folder, "OUT", true);
    if (std::filesystem::exists(folder) && !std::filesystem::is_empty(folder)) {
        throw InputError(fmt::format("{} is not empty; name a new folder, or remove this one first",
                                     folder.string()));
    }
}

/// Opens the file of simulated states, which must not be the store of the fits: a fit that knew the
/// states of a laboratory would be tested on what it was made from.
std::unique_ptr<RunStore> open_states(const std::string& file, const CommonOptions& common) {
    if (file.empty()) return nullptr;
    for (const auto& store : {common.store, RunStore::standard_file()}) {
        if (std::filesystem::weakly_canonical(file) == std::filesystem::weakly_canonical(store)) {
            throw InputError(fmt::format(
                "--states {} is the store that fits learn from; name a file of its own", file));
        }
    }
    return std::make_unique<RunStore>(file);
}

std::string examples() {
    const auto of_instrument = [](bool a_switch) {
        return example_of([=](const Effect& effect) {
            return effect.of_instrument() && effect.is_switch() == a_switch;
        });
    };
    return fmt::format(
        "  pendular virtual-lab my-lab --friction 0.15 --dry --fidelity quick\n"
        "  pendular virtual-lab wet-lab --wet-normal-stresses \"300 Pa, 1 kPa\" --liquid-contents "
        "0.02\n"
        "  pendular virtual-lab odd-lab --dry {} {}\n"
        "  pendular virtual-lab steel-lab --dry --diameter \"1 mm\" --density \"7800 kg/m^3\" "
        "--bead-mass \"250 g\" --speeds \"0.5, 5 rpm\" --order up-and-down\n"
        "  pendular virtual-lab planned --like my-study --friction 0.3 --replicates 3\n"
        "  pendular import wet-lab\n",
        of_instrument(false), of_instrument(true));
}

const char* const about_virtual_lab =
    "Makes test recordings of an annular cell whose friction and effects are known, and writes "
    "them to\n"
    "the new folder OUT as a study. Its study.toml lists no effects; truth.json states the "
    "hidden friction\n"
    "and the hidden effects, and no command reads it. The recordings come from new simulations "
    "with 1.5\n"
    "times the number of grains of --fidelity, which are not stored, so that no calibration "
    "uses them.\n"
    "By default the cell has radii of 21 and 45 mm and holds grains of 500 um and 1050 kg/m^3; "
    "--like STUDY takes\n"
    "these and the set points from a study. Unless a hidden effect changes this, the weight of "
    "the beads is\n"
    "neglected. Normal stresses, inertial numbers and speeds are those that the instrument "
    "displays; hidden\n"
    "effects on it make the true ones differ.";

LabResult simulated(const LabPlan& plan, const std::string& states, const std::stop_token& stop,
                    const CommonOptions& common, Console& console) {
    std::string phase;
    const std::unique_ptr<RunStore> store = open_states(states, common);
    const Workers workers{common.threads, stop,
                          [&](const EnsembleProgress& p) { console.progress(phase, p); },
                          store.get()};
    return simulate_lab(plan, workers, [&](const std::string& name) { phase = name; });
}

}  // namespace

int virtual_lab(const std::vector<std::string>& arguments) {
    Options options("virtual-lab OUT [options]", about_virtual_lab, examples(), true);
    options.set_first_word("OUT (the folder for the new study)");
    LabOptions experiment(options);
    std::int64_t seed = 1, noise_seed = 1;
    options.add("seed", &seed, "seed of simulations and instrument (default 1)");
    options.add("noise-seed", &noise_seed, "seed of the instrument alone (default: --seed)");
    std::string states;
    options.add(
        "states", &states,
        "file of simulated states that laboratories share: those that differ only in noise, "
        "seed of the noise, replicates, order, or in effects that leave the true states "
        "alone simulate nothing again. No fit reads it",
        a_file());
    const EffectOptions effects(options, arguments,
                                "Hidden effects (values with their unit, as in \"0.1 mN m\"; a "
                                "number without a unit is in SI "
                                "units)",
                                why_not_in_lab);
    options.leave_out({"out", "store"});
    const auto common = options.parse(arguments);
    if (!common) {
        return done;
    }
    if (common->out) {
        throw InputError("the study is written to OUT itself; leave out --out");
    }
    const std::filesystem::path& folder = common->study;
    demand_new(folder);
    std::vector<std::string> notes;
    LabPlan plan = experiment.plan(options, notes);
    plan.seed = checked_seed(seed);
    if (options.given("noise-seed")) plan.noise_seed = checked_seed(noise_seed);
    plan.fidelity = common->fidelity;
    plan.shared_states = !states.empty();
    plan.effects = effects.effects();
    check_plan(plan);

    const InterruptGuard guard;
    Console console(*common);
    for (const std::string& note : notes) {
        console.note(note);
    }
    for (const double content : contents_of(plan)) {
        if (const auto warning = pendular_range_warning(content)) {
            console.note(*warning);
        }
    }
    const LabResult result = simulated(plan, states, guard.token(), *common, console);
    const auto truth = to_json(result);
    auto files = study_files(result);
    files["truth.json"] = json_text(truth, 1);
    demand_new(folder);
    write_whole_folder(folder, files);
    console.print(lab_output(result, folder));
    console.next("pendular import " + shell_word(folder));
    console.json(truth);
    return done;
}

}  // namespace pendular::app
