// `pendular effects`: what may be missing from a model.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "app/command.h"
#include "app/console.h"
#include "app/options.h"
#include "data/input_error.h"
#include "reports/effect_pages.h"
#include "sim/effect_catalogue.h"

namespace pendular::app {
namespace {

const char* const about =
    R"(The catalogue of physical effects that a model may lack, of the instrument, the beads, the liquid
and the forces between grains; with a name, one of them whole. A study switches them on by name,
effects = ["torque-offset"] in [model], and may write its own, shown with --study:

  [[effect]]
  name = "speed-drag"                         # lower-case words
  parameter = "drag"                          # what is fitted; "on": a switch, without bounds
  unit = "mN m s/rad"
  lower = -1
  upper = 1
  torque = "torque + drag*angular_velocity"   # the torque shown; at drag = 0 the torque itself

Also: neutral (where the effect is gone, 0), matters (a size worth knowing, a tenth of the range),
summary. Formulas give what the instrument shows: torque, normal_force, height, angular_velocity; or
what the beads show: stress_ratio, solid_fraction. They know the parameter and, in SI units,
  of the instrument  torque, normal_force, height, angular_velocity, liquid_content, bead_volume,
                     time, inner_radius, outer_radius, density, diameter, normal_stress
  of the beads       stress_ratio, solid_fraction, normal_stress, inertial_number, liquid_content,
                     height, time
with + - * / ^ ( ), comparisons, && ||, CONDITION ? A : B, pi, and abs acos asin atan atan2 avg cos
cosh exp ln log (ln) log10 log2 max min rint sign sin sinh sqrt sum tan tanh.)";

const char* const examples = R"(  pendular effects
  pendular effects torque-offset
  pendular effects --study examples/wet
  pendular effects --json -
)";

EffectEntry entry_of(const Effect& effect, const EffectCatalogue& catalogue,
                     const std::optional<Study>& study) {
    EffectEntry entry{&effect, catalogue.is_written(effect)};
    if (study) {
        const auto& listed = study->model.effects;
        entry.standing = {
            std::ranges::find(listed, effect.name, &ListedEffect::name) != listed.end(),
            why_not(effect, *study)};
    }
    return entry;
}

const Effect& named(const EffectCatalogue& catalogue, const std::string& name) {
    try {
        return catalogue.find(name);
    } catch (const std::invalid_argument& error) {
        throw InputError(error.what());
    }
}

void show_one(Console& console, const EffectEntry& entry) {
    for (const auto& line : effect_page(entry)) {
        console.line(line);
    }
    console.json(to_json(entry));
}

void show_all(Console& console, const std::vector<EffectEntry>& entries) {
    console.line(
        fmt::format("{} effects that a model may lack; 'pendular effects NAME' describes "
                    "one",
                    entries.size()));
    for (const auto& line : effects_table(entries)) {
        console.line(line);
    }
    nlohmann::ordered_json json = {{"effects", nlohmann::ordered_json::array()}};
    for (const EffectEntry& entry : entries) {
        if (entry.standing && entry.standing->why_not) {
            console.note(*entry.standing->why_not);
        }
        json["effects"].push_back(to_json(entry));
    }
    console.json(json);
}

}  // namespace

int effects(const std::vector<std::string>& arguments) {
    Options options("effects [EFFECT] [options]", about, examples, false);
    std::vector<std::string> words;
    std::string study_path;
    options.take(&words);
    options.add("study", &study_path,
                "study whose own effects are shown too; says which effects apply to it");
    const auto common = options.parse(arguments);
    if (!common) {
        return done;
    }
    if (words.size() > 1) {
        throw InputError("too many arguments; usage: pendular effects [EFFECT] [options]");
    }
    Console console(*common);
    std::optional<Study> study;
    if (options.given("study")) {
        study = read_study(study_path);
    }
    const EffectCatalogue catalogue = study ? EffectCatalogue(*study) : EffectCatalogue();
    if (!words.empty()) {
        show_one(console, entry_of(named(catalogue, words[0]), catalogue, study));
        return done;
    }
    std::vector<EffectEntry> entries;
    for (const Effect& effect : catalogue.all()) {
        entries.push_back(entry_of(effect, catalogue, study));
    }
    show_all(console, entries);
    return done;
}

}  // namespace pendular::app
