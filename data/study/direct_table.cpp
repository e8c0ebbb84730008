#include "data/study/direct_table.h"

#include <fmt/format.h>

#include "data/study/study_table.h"

namespace pendular {
namespace {

Word required(const StudyTable& table, std::string_view key, const char* what) {
    if (auto word = table.stated(key)) return *word;
    throw InputError(table.position(),
                     fmt::format("{} lacks '{}'; add {}", table.name(), key, what));
}

StatedDirect read_one(const StudyTable& table) {
    const Word effect = required(
                   table, "effect",
                   "the effect that was or can be measured, such as effect = \"torque-offset\""),
               error = required(table, "error", "the standard error with its unit");
    StatedDirect stated;
    stated.effect = effect.text, stated.effect_position = effect.position;
    stated.error = error.text, stated.error_position = error.position;
    return stated;
}

}  // namespace

std::vector<StatedDirect> read_direct(const StudyTable& root) {
    std::vector<StatedDirect> all;
    for (const StudyTable& table : root.tables("direct", {"effect", "value", "error"})) {
        all.push_back(read_one(table));
        const Word value = required(table, "value", "the measured value with its unit");
        if (value.text.empty()) table.refuse("value", "is empty; write the measured value");
        all.back().value = value.text, all.back().value_position = value.position;
    }
    return all;
}

std::vector<StatedDirect> read_direct_of_rig(const StudyTable& rig) {
    std::vector<StatedDirect> all;
    for (const StudyTable& table : rig.tables("direct", {"effect", "error", "cost"})) {
        all.push_back(read_one(table));
        all.back().cost = table.quantity("cost", "1").value_or(1);
        if (!(all.back().cost > 0)) table.refuse("cost", "must be positive");
    }
    return all;
}

}  // namespace pendular
