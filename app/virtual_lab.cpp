#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/command.h"
#include "app/console.h"
#include "app/effect_options.h"
#include "app/interrupt.h"
#include "app/options.h"
#include "data/files/json_text.h"
#include "data/files/write_whole.h"
#include "data/input_error.h"
#include "data/quantities/units.h"
#include "reports/truth.h"
#include "sim/lab/virtual_lab.h"
#include "sim/lab/virtual_study.h"

namespace pendular::app {
namespace {

/// Values of options with units, as text, with their defaults.
struct Words {
    std::string dry_normal_stresses = "0.3, 1, 3 kPa";
    std::string wet_normal_stresses = "0.3, 0.6, 1, 3 kPa";
    std::string liquid_contents = "0.007, 0.03";
    std::string inertial_numbers = "0.003, 0.03";
    std::string bead_mass = "60 g";
    std::string surface_tension = "20.6 mN/m";
};

std::vector<double> list(const std::string& words, const char* unit, const std::string& option) {
    try {
        return quantities_in_si(words, Unit(unit));
    } catch (const std::invalid_argument& error) {
        throw InputError(fmt::format("{}: {}", option, error.what()));
    }
}

double single(const std::string& words, const char* unit, const std::string& option) {
    const std::vector<double> values = list(words, unit, option);
    if (values.size() != 1 || !(values.front() > 0)) {
        throw InputError(fmt::format("{} \"{}\": one value above 0 is needed", option, words));
    }
    return values.front();
}

void take(const Words& words, bool dry, LabPlan& plan) {
    plan.dry_normal_stresses = list(words.dry_normal_stresses, "Pa", "--dry-normal-stresses");
    plan.wet_normal_stresses = list(words.wet_normal_stresses, "Pa", "--wet-normal-stresses");
    plan.liquid_contents = list(words.liquid_contents, "1", "--liquid-contents");
    plan.inertial_numbers = list(words.inertial_numbers, "1", "--inertial-numbers");
    plan.cell.bead_volume = single(words.bead_mass, "kg", "--bead-mass") / plan.grains.density;
    plan.liquid.surface_tension = single(words.surface_tension, "N/m", "--surface-tension");
    if (dry) {
        plan.liquid_contents.clear();
    }
}

/// Checks that a folder is new or empty, so that no earlier measurement is lost or mixed up.
/// @throws InputError where it holds files or cannot be written
void demand_new(const std::filesystem::path& folder) {
    demand_writable(folder, "OUT", true);
    if (std::filesystem::exists(folder) && !std::filesystem::is_empty(folder)) {
        throw InputError(fmt::format("{} is not empty; name a new folder, or remove this one first",
                                     folder.string()));
    }
}

void print_wet_step(Console& console, const LabRecording& recording, const LabStep& step) {
    const Mean& found = step.run[dem::Observable::liquid_content];
    const auto& wetting = *step.run.parameters.wetting;
    console.line(fmt::format("  {:<16} {:>11g} {:>9.3g} {:>9g} {:>10.3e}   {:g}: {}",
                             recording.file, step.condition.normal_stress, wetting.reduced_pressure,
                             step.condition.inertial_number, wetting.bridge_volume,
                             step.imposed.liquid_content,
                             with_error(found.value, found.standard_error)));
}

void print_result(Console& console, const LabResult& result, const std::filesystem::path& folder) {
    const LabPlan& plan = result.plan;
    std::size_t steps = 0;
    for (const auto& recording : result.recordings) {
        steps += recording.steps.size();
    }
    const auto counted = [](std::size_t count, const char* what) {
        return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
    };
    console.answer(fmt::format(
        "{} holds {} with {} in all, with noise {:g}; truth.json states the hidden friction{}.",
        folder.string(), counted(result.recordings.size(), "recording"), counted(steps, "step"),
        plan.instrument.noise, plan.effects.empty() ? "" : " and the hidden effects"));
    console.line(fmt::format(
        "Each step has its own simulation and seed: {} grains, stiffness number {:g}, averages "
        "over a strain of {:g}.{}",
        result.recordings.front().steps.front().run.parameters.grains,
        plan.fidelity.stiffness_number, plan.fidelity.strain,
        result.pilots > 0
            ? fmt::format(" {} shorter simulations found the bridge volumes.", result.pilots)
            : ""));
    if (!plan.liquid_contents.empty()) {
        console.line(fmt::format("  {:<16} {:>11} {:>9} {:>9} {:>10}   {}", "wet", "normal",
                                 "reduced", "inertial", "bridge", "liquid content"));
        console.line(fmt::format("  {:<16} {:>11} {:>9} {:>9} {:>10}   {}", "recording",
                                 "stress [Pa]", "pressure", "number", "volume/a^3",
                                 "requested: reached"));
    }
    for (const auto& recording : result.recordings) {
        for (const auto& step : recording.steps) {
            if (!step.imposed.dry()) print_wet_step(console, recording, step);
        }
    }
    for (const auto& note : result.notes) {
        console.note(note);
    }
}

void declare(Options& options, LabPlan& plan, Words& words) {
    options.add("friction", &plan.friction,
                "hidden friction coefficient between grains [1] (default 0.09)");
    options.add("noise", &plan.instrument.noise,
                "scatter of the mean values of steps, as a multiple of 1 % of the torque and 0.2 % "
                "of the solid fraction (default 1)");
    options.add("drift", &plan.instrument.drift,
                "drift over a recording (standard deviation), as a multiple of 1 % of the torque "
                "and 0.2 % of the solid fraction (default 0)");
    options.add("dry-normal-stresses", &words.dry_normal_stresses,
                "normal stresses of dry recordings, with a unit (default \"0.3, 1, 3 kPa\")");
    options.add("wet-normal-stresses", &words.wet_normal_stresses,
                "normal stresses of wet recordings, with a unit (default \"0.3, 0.6, 1, 3 kPa\")");
    options.add("liquid-contents", &words.liquid_contents,
                "liquid volume over grain volume [1] (default \"0.007, 0.03\")");
    options.add("inertial-numbers", &words.inertial_numbers,
                "inertial numbers: shear rate times sqrt(m/(a s22)), with mass m and diameter a of "
                "a grain and normal stress s22 [1] (default \"0.003, 0.03\")");
    options.add("replicates", &plan.replicates,
                "number of recordings of each liquid content (default 2)");
    options.add("rows", &plan.instrument.rows,
                "number of recorded rows of each step (default 400)");
    options.add("bead-mass", &words.bead_mass,
                "mass of the beads in the cell, with its unit (default \"60 g\")");
    options.add("surface-tension", &words.surface_tension,
                "surface tension of the liquid, with its unit (default \"20.6 mN/m\")");
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
        "  pendular import wet-lab\n",
        of_instrument(false), of_instrument(true));
}

}  // namespace

int virtual_lab(const std::vector<std::string>& arguments) {
    LabPlan plan;
    Words words;
    Options options(
        "virtual-lab OUT [options]",
        "Makes test recordings of an annular cell whose friction and effects are known, and writes "
        "them to\n"
        "the new folder OUT as a study. Its study.toml lists no effects; truth.json states the "
        "hidden friction\n"
        "and the hidden effects, and no command reads it. The recordings come from new simulations "
        "with 1.5\n"
        "times the number of grains of --fidelity, which are not stored, so that no calibration "
        "uses them.\n"
        "The cell has radii of 21 and 45 mm and holds grains of 500 um and 1050 kg/m^3. Unless a "
        "hidden effect\n"
        "changes this, the contact angle is 0 and the weight of the beads is neglected. Normal "
        "stresses and\n"
        "inertial numbers are those that the instrument displays; hidden effects on it make the "
        "true ones differ.",
        examples(), true);
    options.set_first_word("OUT (the folder for the new study)");
    declare(options, plan, words);
    std::int64_t seed = 1;
    options.add("seed", &seed, "seed of simulations and instrument (default 1)");
    bool dry = false;
    options.add_switch("dry", &dry, "make no wet recordings");
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
    if (dry && (options.given("wet-normal-stresses") || options.given("liquid-contents") ||
                options.given("surface-tension"))) {
        throw InputError(
            "--dry leaves out what --wet-normal-stresses, --liquid-contents and --surface-tension "
            "name; remove one or the other");
    }
    const std::filesystem::path& folder = common->study;
    demand_new(folder);
    plan.seed = checked_seed(seed);
    plan.fidelity = common->fidelity;
    take(words, dry, plan);
    plan.effects = effects.effects();
    check_plan(plan);

    const InterruptGuard guard;
    Console console(*common);
    for (const double content : plan.liquid_contents) {
        if (const auto warning = pendular_range_warning(content)) {
            console.note(*warning);
        }
    }
    std::string phase;
    const Workers workers{common->threads, guard.token(),
                          [&](const EnsembleProgress& p) { console.progress(phase, p); }};
    const LabResult result =
        simulate_lab(plan, workers, [&](const std::string& name) { phase = name; });
    const auto truth = to_json(result);
    auto files = study_files(result);
    files["truth.json"] = json_text(truth, 1);
    demand_new(folder);
    write_whole_folder(folder, files);
    print_result(console, result, folder);
    console.next("pendular import " + shell_word(folder));
    console.json(truth);
    return done;
}

}  // namespace pendular::app
