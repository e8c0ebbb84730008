#include "workflow/proposed_effects.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "data/files/write_whole.h"
#include "data/study/study_edit.h"
#include "data/study/study_table.h"

namespace pendular {
namespace {

constexpr const char* beginning =
    "# Changes that would explain the readings, as 'pendular diagnose' found them. To add one:\n"
    "# pendular add STUDY --proposed NUMBER, or copy its table [[effect]] to study.toml and list\n"
    "# its name in the effects of [model].\n";

}  // namespace

std::string effect_table(const WrittenEffect& effect) {
    // The texts may come from a file of somebody else.
    std::string text = fmt::format("[[effect]]\nname = {}\n", toml_string(effect.name));
    if (!effect.summary.empty()) text += fmt::format("summary = {}\n", toml_string(effect.summary));
    text +=
        fmt::format("parameter = {}\nunit = {}\nlower = {:.6g}\nupper = {:.6g}\nmatters = {:.6g}\n",
                    toml_string(effect.parameter), toml_string(effect.unit), effect.lower,
                    effect.upper, effect.smallest_of_interest);
    if (effect.neutral != 0) text += fmt::format("neutral = {:.6g}\n", effect.neutral);
    for (const Formula& formula : effect.formulas) {
        text += fmt::format("{} = {}\n", formula.target, toml_string(formula.text));
    }
    return text;
}

void write_proposed(const std::filesystem::path& file, const ProposedEffects& proposed) {
    if (proposed.proposals.empty()) {
        std::filesystem::remove(file);
        return;
    }
    std::string text = beginning;
    for (const auto& names : proposed.proposals) {
        std::vector<std::string> words;
        for (const std::string& name : names) {
            words.push_back(toml_string(name));
        }
        text += fmt::format("\n[[proposal]]\neffects = [{}]\n", fmt::join(words, ", "));
    }
    for (const WrittenEffect& effect : proposed.effects) {
        text += "\n" + effect_table(effect);
    }
    write_whole(file, text);
}

ProposedEffects read_proposed(const std::filesystem::path& file) {
    std::error_code error;
    if (!std::filesystem::exists(file, error)) return {};
    const StudyTable root = StudyTable::read(file, {"proposal", "effect"});
    ProposedEffects proposed{.proposals = {}, .effects = read_written_effects(root)};
    for (const StudyTable& table : root.tables("proposal", {"effects"})) {
        proposed.proposals.push_back(table.words("effects", {}));
    }
    return proposed;
}

std::vector<std::string> proposal(const std::filesystem::path& file, std::int64_t number) {
    const auto proposals = read_proposed(file).proposals;
    if (proposals.empty()) {
        throw InputError({file.string()},
                         "holds no proposal; 'pendular diagnose' writes proposals where no known "
                         "effect explains the readings");
    }
    if (number < 1 || number > std::ssize(proposals)) {
        throw InputError(
            {file.string()},
            fmt::format("holds the proposal{} 1{}; there is no proposal {}",
                        proposals.size() == 1 ? "" : "s",
                        proposals.size() == 1 ? "" : fmt::format(" to {}", proposals.size()),
                        number));
    }
    return proposals[static_cast<std::size_t>(number - 1)];
}

}  // namespace pendular
