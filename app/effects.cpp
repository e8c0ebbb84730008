// `pendular effects`: the catalogue of effects that a model may lack.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "app/command.h"
#include "app/console.h"
#include "app/effect_options.h"
#include "app/open_session.h"
#include "app/options.h"
#include "data/files/write_whole.h"
#include "data/input_error.h"
#include "reports/draw_figure.h"
#include "reports/effect_pages.h"
#include "reports/page/effect_picture.h"
#include "sim/catalogue/effect_catalogue.h"
#include "workflow/json/commands.h"
#include "workflow/study_input.h"

namespace pendular::app {
namespace {

const char* const about_effects =
    R"(Lists the physical effects that a model may lack: effects of the instrument, the grains, the liquid
and the forces between grains. With a name, describes one effect in full. 'pendular add' writes an
effect into study.toml: effects = ["torque-offset"] in section [model].

A study may also define its own effects by formulas. With --study, the list includes the effects of
the study. Example:

  [[effect]]
  name = "speed-drag"                         # lower-case words joined by hyphens
  parameter = "drag"                          # the fitted parameter; "on" makes a switch (no bounds)
  unit = "mN m s/rad"
  lower = -1
  upper = 1
  torque = "torque + drag*angular_velocity"   # left: displayed torque; right: true torque

Optional keys: neutral (value at which the effect vanishes, default 0), matters (smallest size of
interest, default a tenth of the range), summary, measured_by (what measures the parameter directly,
such as "the torque of the empty cell"), measured_to (standard error of this measurement). A formula
sets a quantity that the instrument shows (torque, normal_force, height or angular_velocity), a
quantity of the flow (stress_ratio or solid_fraction), or a property of grains and liquid
(friction_difference, which is added to the fitted friction, or surface_tension). A formula may
contain the parameter and, in SI units,
  on the instrument  torque, normal_force, height, angular_velocity, liquid_content, bead_volume,
                     time, inner_radius, outer_radius, density, diameter, normal_stress
  on the flow        stress_ratio, solid_fraction, normal_stress, inertial_number, liquid_content,
                     height, time
  on the grains      friction_difference, surface_tension, normal_stress, inertial_number,
                     liquid_content, height, time
with + - * / ^ ( ), comparisons, && ||, CONDITION ? A : B, pi, and abs acos asin atan atan2 avg cos
cosh exp ln log (ln) log10 log2 max min rint sign sin sinh sqrt sum tan tanh.

With --manual DIR, the command writes a page on each effect in Markdown, with a picture of what
happens in the cell and a figure of the predicted change of the readings, and DIR/index.md with a
list of the pages.)";

const char* const effects_examples = R"(  pendular effects
  pendular effects torque-offset
  pendular effects --study examples/wet
  pendular effects --json -
  pendular effects --manual manual
)";

EffectEntry entry_of(const Effect& effect, const EffectCatalogue& catalogue,
                     const std::optional<Study>& study) {
    EffectEntry entry{&effect, catalogue.is_written(effect)};
    if (study) {
        const auto& listed = study->model.effects;
        entry.status = {std::ranges::find(listed, effect.name, &ListedEffect::name) != listed.end(),
                        obstacle(effect, *study)};
    }
    return entry;
}

const Effect& named(const EffectCatalogue& catalogue, const std::string& name, bool of_study) {
    try {
        return catalogue.find(name);
    } catch (const std::invalid_argument& error) {
        throw InputError(error.what() +
                         std::string(of_study ? ""
                                              : "\n  For an effect that a study defines, add "
                                                "--study STUDY."));
    }
}

void show_one(Console& console, const EffectEntry& entry) {
    for (const auto& line : effect_page(entry)) {
        console.line(line);
    }
    console.json(to_json(entry));
}

void show_all(Console& console, const std::vector<EffectEntry>& entries) {
    console.print(effects_output(entries, console.all()));
    console.json(to_json(entries));
}

/// Draws the figures of effects for a manual: the signatures, changes of the readings by an effect.
class Signatures {
  public:
    Signatures(std::filesystem::path folder, const EffectCatalogue& catalogue,
               const Fidelity& fidelity)
        : folder_(std::move(folder)), study_(signature_study(catalogue.all())) {
        // Without the user's store of runs, so that the manual is the same everywhere.
        if (auto known = known_runs(study_, fidelity, nullptr)) {
            simulation_ = std::make_shared<EmulatedSimulation>(
                study_, fidelity, Emulator(known->runs, std::move(known->hyperparameters)));
        }
    }

    /// Draws the figure of an effect and returns its Markdown; empty where the figure cannot be
    /// drawn, for the reason `why_none`.
    std::string draw_one(const Effect& effect) {
        why_none_ = "there is no atlas to predict from; name one with $PENDULAR_ATLAS";
        if (!simulation_) {
            return "";
        }
        try {
            draw(signature_figure(effect, study_, simulation_), folder_ / "figures");
        } catch (const std::logic_error& error) {  // no atlas run has it, or no cell shows it
            why_none_ = error.what();
            return "";
        }
        return fmt::format(
            "![signature of {0}](figures/{0}.svg)\n\n{1}\n\nAlso as [PNG](figures/{0}.png), "
            "[PDF](figures/{0}.pdf) and [numbers](figures/{0}.csv).",
            effect.name, signature_caption(effect, study_));
    }
    /// Reason why the last effect has no figure.
    const std::string& why_none() const { return why_none_; }

  private:
    std::filesystem::path folder_;
    Study study_;
    std::shared_ptr<const EmulatedSimulation> simulation_;
    std::string why_none_;
};

void write_manual(Console& console, const std::filesystem::path& folder,
                  const std::vector<EffectEntry>& entries, Signatures signatures) {
    std::size_t drawn = 0;
    std::vector<std::pair<std::string, bool>> pages;
    for (const EffectEntry& entry : entries) {
        const std::string& name = entry.effect->name;
        write_whole(folder / "figures" / (name + "-cell.svg"), cell_picture(*entry.effect));
        std::string figure = signatures.draw_one(*entry.effect);
        pages.emplace_back(name, !figure.empty());
        if (figure.empty()) {
            console.note(fmt::format("{} has no figure: {}", name, signatures.why_none()));
            figure = fmt::format("There is no figure: {}.", signatures.why_none());
        } else {
            ++drawn;
        }
        const std::string picture =
            fmt::format("![What happens in the cell](figures/{}-cell.svg)\n\n", name);
        write_whole(folder / (name + ".md"), manual_page(entry, picture + figure));
    }
    write_whole(folder / "index.md", manual_index(entries));
    console.line(fmt::format("Pages on {} effects, {} of them with a figure, are written to {}.",
                             entries.size(), drawn, (folder / "index.md").string()));
    console.json(manual_json(folder / "index.md", pages));
}

}  // namespace

int effects(const std::vector<std::string>& arguments) {
    Options options("effects [EFFECT] [options]", about_effects, effects_examples, false);
    std::vector<std::string> words;
    std::string study_path, manual;
    options.take(&words, one_of(names_of_effects()));
    options.leave_out({"out", "store", "threads", "quiet"});
    options.set_fidelity(
        "stiffness number for which --manual predicts the figures: quick and standard "
        "1000, paper 8400");
    options.add("study", &study_path,
                "study whose own effects are listed too; the table then says whether each effect "
                "applies to this study",
                a_study());
    options.add("manual", &manual, "folder for a manual of all effects: Markdown and figures",
                a_folder());
    const auto common = options.parse(arguments);
    if (!common) {
        return done;
    }
    if (words.size() > 1) {
        throw InputError("too many arguments; usage: pendular effects [EFFECT] [options]");
    }
    if (!words.empty() && options.given("manual")) {
        throw InputError("--manual writes pages of all effects; leave out the name of one");
    }
    Console console(*common);
    std::optional<Study> study;
    if (options.given("study")) {
        study = read_study(study_path);
        protect_inputs(*study, places_of(*common, {}));
    }
    const EffectCatalogue catalogue = study ? EffectCatalogue(*study) : EffectCatalogue();
    if (!words.empty()) {
        show_one(console,
                 entry_of(named(catalogue, words[0], study.has_value()), catalogue, study));
        return done;
    }
    std::vector<EffectEntry> entries;
    for (const Effect& effect : catalogue.all()) {
        entries.push_back(entry_of(effect, catalogue, study));
    }
    if (options.given("manual")) {
        demand_writable(manual, "--manual", true);
        write_manual(console, manual, entries, Signatures(manual, catalogue, common->fidelity));
        return done;
    }
    show_all(console, entries);
    return done;
}

}  // namespace pendular::app
