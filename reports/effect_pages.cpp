#include "reports/effect_pages.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <sstream>

#include "data/effect_parameter.h"
#include "reports/with_error.h"
#include "reports/words.h"
#include "sim/lab/lab_plan.h"

namespace pendular {
namespace {

/// Group of the catalogue, by the part of the experiment that an effect changes.
struct Group {
    const char* heading;               ///< heading of the group in tables
    bool in_simulate, in_virtual_lab;  ///< whether these commands have options for the effects
};

/// In the order of `Part`.
constexpr std::array<Group, 5> effect_groups = {{
    {"the instrument", false, true},
    {"the properties of the grains and the liquid", true, true},
    {"the forces between grains and the grain sizes", true, true},
    {"the formula of the strength of wet grains (base model \"mohr-coulomb\" or \"rumpf\"; the "
     "base model \"dem\" uses no formula)",
     false, false},
    {"the predicted shear stress and solid fraction", false, false},
}};

std::size_t group_index(const Effect& effect) {
    return static_cast<std::size_t>(part_changed(effect));
}

/// Readings that an effect can change, as a sentence has them: "wet readings".
std::string readings_text(const Effect& effect) {
    return effect.touches == Touches::failure
               ? "readings at failure (peaks)"
               : fmt::format("{} readings", readings_changed(effect));
}

/// Entry of the column "applies" of a table.
std::string applies(const EffectEntry& entry) {
    if (!entry.status) return "";
    if (entry.status->obstacle) return entry.status->obstacle->brief;
    return entry.status->listed ? "in the model" : "yes";
}

std::string unit_of(const EffectParameter& parameter) {
    return parameter.is_switch() ? "switch" : printed_unit(parameter).name;
}

/// Value at which an effect of one parameter vanishes, as text.
std::string neutral_text(const Effect& effect, const EffectParameter& p) {
    return effect.given_by_liquid ? "the value in study.toml" : printed_value(p.neutral, p);
}

}  // namespace

std::string dependences(const Effect& effect) {
    std::vector<std::string> texts;
    for (const std::string& name : effect.acts_through) {
        texts.push_back(name.starts_with("1/")
                            ? spoken(name.substr(2)) + " (largest at small values)"
                            : spoken(name));
    }
    return fmt::format("{}", fmt::join(texts, ", "));
}

namespace {

std::string table_line(const std::string& name, const std::string& parameter,
                       const std::string& unit, const std::string& touches,
                       const std::string& status, const std::string& summary) {
    return fmt::format("  {:<23} {:<16} {:<8} {:<8} {}{}", name, parameter, unit, touches,
                       status.empty() ? "" : fmt::format("{:<20} ", status), summary);
}

/// Adds the lines of an effect to a table, one per parameter. Only the first line names the effect.
void add_effect(std::vector<std::string>& lines, const EffectEntry& entry) {
    const Effect& effect = *entry.effect;
    for (std::size_t k = 0; k < effect.parameters.size(); ++k) {
        const EffectParameter& p = effect.parameters[k];
        lines.push_back(k == 0
                            ? table_line(effect.name, p.name, unit_of(p), readings_changed(effect),
                                         applies(entry), effect.summary)
                            : table_line("", p.name, unit_of(p), "", "", p.meaning));
    }
}

std::string field(const char* name, const std::string& text) {
    return fmt::format("  {:<13} {}", name, text);
}

/// Adds a field of several lines to a page.
void add_lines(std::vector<std::string>& page, const char* name, const std::string& text) {
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line); name = "") {
        page.push_back(field(name, line));
    }
}

std::string parameter_text(const Effect& effect, const EffectParameter& p) {
    if (p.is_switch()) return fmt::format("{}, a switch (1 on, 0 off): {}", p.name, p.meaning);
    return fmt::format("{}: {}; {}, no effect at {}, size that matters {}", p.name, p.meaning,
                       printed_bounds(p), neutral_text(effect, p),
                       printed_value(p.smallest_of_interest, p));
}

/// Options that set an effect to its smallest size of interest, `--torque-offset.torque "0.1
/// mN m"`.
std::string options_of(const Effect& effect) {
    std::vector<std::string> options;
    for (const EffectParameter& p : effect.parameters) {
        const double from =
            effect.given_by_liquid ? effect.unlisted_value(LabPlan().liquid) : p.neutral;
        options.push_back(
            fmt::format("--{}.{} {}", effect.name, p.name,
                        p.is_switch() ? "1" : printed_word(from + p.smallest_of_interest, p)));
    }
    return fmt::format("{}", fmt::join(options, " "));
}

/// Command that simulates one sample with an effect.
std::string simulate_command(const Effect& effect) {
    return fmt::format("pendular simulate {}{}",
                       effect.touches == Touches::wet ? "--reduced-pressure 3 " : "",
                       options_of(effect));
}

void add_how_to(std::vector<std::string>& page, const EffectEntry& entry) {
    const Effect& effect = *entry.effect;
    const Group& group = effect_groups[group_index(effect)];
    page.push_back(field("in a study", fmt::format("pendular add STUDY {0}, which writes [model] "
                                                   "effects = [\"{0}\"]",
                                                   effect.name)));
    if (entry.written) {
        return;
    }
    if (group.in_virtual_lab) {
        page.push_back(
            field("virtual lab", fmt::format("pendular virtual-lab OUT {}", options_of(effect))));
    }
    if (group.in_simulate) {
        page.push_back(field("simulation", simulate_command(effect)));
    }
}

std::string status_text(const EffectEntry& entry) {
    if (entry.status->obstacle) return entry.status->obstacle->sentence;
    return entry.status->listed ? "the model has the effect" : "the effect can be added";
}

/// Text with the special characters of Markdown escaped.
std::string markdown(const std::string& words) {
    constexpr std::string_view special = "\\`*_|<>[]";
    std::string text;
    for (const char c : words) {
        text += special.find(c) != special.npos ? std::string{'\\', c} : std::string{c};
    }
    return text;
}

std::string code_block(const std::string& language, const std::string& text) {
    return fmt::format("```{}\n{}\n```\n", language, text);
}

std::string parameter_row(const Effect& effect, const EffectParameter& p) {
    if (p.is_switch()) {
        return fmt::format("| `{}` | switch | 0 or 1 | 0 | 1 | {} |\n", p.name,
                           markdown(p.meaning));
    }
    return fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", p.name, markdown(unit_of(p)),
                       printed_bounds(p), neutral_text(effect, p),
                       printed_value(p.smallest_of_interest, p), markdown(p.meaning));
}

std::string parameter_table(const Effect& effect) {
    std::string text =
        "| parameter | unit | bounds | value without effect | size that matters | meaning |\n"
        "|---|---|---|---|---|---|\n";
    for (const EffectParameter& p : effect.parameters) {
        text += parameter_row(effect, p);
    }
    return text;
}

std::string manual_how_to(const EffectEntry& entry) {
    const Effect& effect = *entry.effect;
    const Group& group = effect_groups[group_index(effect)];
    std::string text =
        fmt::format("`pendular add STUDY {}` writes in study.toml:\n\n", effect.name) +
        code_block("toml", fmt::format("[model]\neffects = [\"{}\"]", effect.name));
    if (!entry.written && group.in_virtual_lab) {
        text += "\nTo make test recordings with the effect:\n\n" +
                code_block("sh", fmt::format("pendular virtual-lab my-lab {}", options_of(effect)));
    }
    if (!entry.written && group.in_simulate) {
        text += "\nTo simulate one sample with the effect:\n\n" +
                code_block("sh", simulate_command(effect));
    }
    return text;
}

std::string manual_sources(const EffectEntry& entry) {
    std::string text;
    for (const std::string& reference : entry.effect->references) {
        text += fmt::format("- {}{}\n", entry.written ? "written in " : "", markdown(reference));
    }
    return text;
}

}  // namespace

std::vector<std::string> effects_table(const std::vector<EffectEntry>& entries) {
    const bool study = std::ranges::any_of(
        entries, [](const EffectEntry& entry) { return entry.status.has_value(); });
    std::vector<std::string> lines = {
        table_line("effect", "parameter", "unit", "readings", study ? "applies" : "", "meaning")};
    for (std::size_t g = 0; g < effect_groups.size(); ++g) {
        const auto begin = lines.size();
        for (const EffectEntry& entry : entries) {
            if (group_index(*entry.effect) == g) {
                add_effect(lines, entry);
            }
        }
        if (lines.size() > begin) {
            lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(begin),
                         effect_groups[g].heading);
        }
    }
    return lines;
}

/// Standard error of the direct measurement of an effect's parameter, as the end of a sentence.
std::string reachable_text(const Effect& effect) {
    if (effect.reachable_error == 0) return "";
    return fmt::format(", to a standard error of {}",
                       with_unit(effect.reachable_error, effect.parameters.front().unit));
}

std::vector<std::string> effect_page(const EffectEntry& entry) {
    const Effect& effect = *entry.effect;
    std::vector<std::string> page = {fmt::format("{}: {}", effect.name, effect.summary)};
    add_lines(page, "equation", effect.equation);
    if (effect.given_by_liquid) {
        page.push_back(field("always on",
                             "in a study with a liquid, at the value in study.toml; adding the "
                             "effect fits the value"));
    }
    page.push_back(field("acts on", effect_groups[group_index(effect)].heading));
    page.push_back(field("changes", readings_text(effect)));
    for (const EffectParameter& parameter : effect.parameters) {
        page.push_back(field("parameter", parameter_text(effect, parameter)));
    }
    if (!effect.acts_through.empty()) page.push_back(field("varies with", dependences(effect)));
    if (!effect.directly.empty()) {
        page.push_back(field("measured by", effect.directly + reachable_text(effect) +
                                                "; see 'pendular next --help'"));
    }
    for (const std::string& reference : effect.references) {
        page.push_back(field(entry.written ? "written in" : "source", reference));
    }
    add_how_to(page, entry);
    if (entry.status) {
        page.push_back(field("this study", status_text(entry)));
    }
    return page;
}

std::string manual_page(const EffectEntry& entry, const std::string& figure) {
    const Effect& effect = *entry.effect;
    std::string summary = effect.summary;
    if (!summary.empty()) summary[0] = static_cast<char>(std::toupper(summary[0]));
    std::string text =
        fmt::format("# {}\n\n{}.\n\n", effect.name, markdown(summary)) +
        code_block("", effect.equation) + '\n' + parameter_table(effect) +
        fmt::format("\nThe effect acts on {} and changes {}.",
                    effect_groups[group_index(effect)].heading, readings_text(effect));
    if (!effect.acts_through.empty()) {
        text += fmt::format(" The change of the readings depends on {}.", dependences(effect));
    }
    if (!effect.directly.empty()) {
        text += fmt::format(
            " The parameter can be measured directly by {}; the result goes into a table "
            "`[[direct]]` of study.toml.",
            markdown(effect.directly));
    }
    text += "\n\n## Change of the readings\n\n" + figure + "\n\n## How to switch it on\n\n" +
            manual_how_to(entry);
    if (!effect.references.empty()) {
        text += "\n## Sources\n\n" + manual_sources(entry);
    }
    return text + "\n[All effects](index.md)\n";
}

std::string manual_index(const std::vector<EffectEntry>& entries) {
    std::string text =
        "# Effects\n\nPhysical effects that a model may lack. `pendular effects --manual` writes "
        "these pages.\n";
    for (std::size_t g = 0; g < effect_groups.size(); ++g) {
        std::string rows;
        for (const EffectEntry& entry : entries) {
            const Effect& effect = *entry.effect;
            if (group_index(effect) != g) continue;
            std::vector<std::string> parameters;
            for (const EffectParameter& p : effect.parameters) {
                parameters.push_back(fmt::format("`{}` [{}]", p.name, markdown(unit_of(p))));
            }
            rows += fmt::format("| [{0}]({0}.md) | {1} | {2} | {3} |\n", effect.name,
                                fmt::join(parameters, ", "), readings_changed(effect),
                                markdown(effect.summary));
        }
        if (!rows.empty()) {
            text += fmt::format(
                "\nEffects on {}:\n\n| effect | parameter | readings | meaning |\n"
                "|---|---|---|---|\n{}",
                markdown(effect_groups[g].heading), rows);
        }
    }
    return text;
}

Output effects_output(const std::vector<EffectEntry>& entries, bool all) {
    Output output;
    output.answer(fmt::format(
        "The catalogue has {} effects. 'pendular effects NAME' describes the effect NAME.",
        entries.size()));
    output.lines(effects_table(entries));
    const auto lacks = [](const EffectEntry& entry) {
        return entry.status && entry.status->obstacle;
    };
    if (std::ranges::any_of(entries, lacks)) {
        output.line(
            "'pendular effects NAME --study STUDY' says what the study lacks for an effect.");
    }
    for (const EffectEntry& entry : entries) {
        if (all && lacks(entry)) output.note(entry.status->obstacle->sentence);
    }
    return output;
}

}  // namespace pendular
