#include "bench/hidden_effects/judgement.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

#include "data/files/csv.h"
#include "data/files/write_whole.h"

namespace pendular::bench {

bool verdict_is(const LabStudy& s, std::string_view verdict) {
    return s.outcome->verdict == verdict;
}

bool flagged(const LabStudy& s) {
    return verdict_is(s, "unknown") || verdict_is(s, "suspect-measurement");
}

bool alarms(const LabStudy& s) {
    return !verdict_is(s, "nothing-missing") && !verdict_is(s, "inconclusive");
}

namespace {

bool names_truth(const LabStudy& s) {
    return !s.truth->hidden.empty() && s.outcome->named.size() == s.truth->hidden.size() &&
           std::ranges::all_of(s.outcome->named,
                               [&](const std::string& name) { return s.truth->hides(name); });
}

}  // namespace

bool points_at_truth(const LabStudy& s) {
    return std::ranges::any_of(s.outcome->named,
                               [&](const std::string& name) { return s.truth->hides(name); });
}

bool right(const LabStudy& s) {
    return verdict_is(s, "missing") && names_truth(s);
}

bool confidently_wrong(const LabStudy& s) {
    if (verdict_is(s, "nothing-missing")) return !s.truth->hidden.empty();
    return verdict_is(s, "missing") &&
           !std::ranges::all_of(s.outcome->named,
                                [&](const std::string& name) { return s.truth->hides(name); });
}

std::string confusion_column(const LabStudy& s) {
    if (!alarms(s)) return "nothing";
    if (verdict_is(s, "missing")) return fmt::format("{}", fmt::join(s.outcome->named, " + "));
    return s.outcome->verdict;
}

namespace {

using Confusion = std::map<std::pair<std::string, std::string>, std::size_t>;

Confusion confusion_of(const Studies& studies) {
    Confusion counts;
    for (const LabStudy& s : studies) {
        ++counts[{s.truth->name, confusion_column(s)}];
    }
    return counts;
}

/// Nothing first, then single effects and pairs, then what is not named.
std::vector<std::string> columns_of(const Confusion& counts) {
    const std::vector<std::string> last = {"indistinguishable", "suspect-measurement", "unknown"};
    std::set<std::string> named;
    for (const auto& [cell, count] : counts) {
        if (cell.second != "nothing" && std::ranges::find(last, cell.second) == last.end()) {
            named.insert(cell.second);
        }
    }
    std::vector<std::string> columns = {"nothing"};
    columns.insert(columns.end(), named.begin(), named.end());
    columns.insert(columns.end(), last.begin(), last.end());
    return columns;
}

}  // namespace

void write_confusion(const std::filesystem::path& file, const std::vector<std::string>& truths,
                     const Studies& studies) {
    const Confusion counts = confusion_of(studies);
    const auto columns = columns_of(counts);
    std::string text = fmt::format("truth,{}\n", fmt::join(columns, ","));
    for (const std::string& truth : truths) {
        text += csv_cell(truth);
        for (const std::string& column : columns) {
            const auto found = counts.find({truth, column});
            text += fmt::format(",{}", found == counts.end() ? 0 : found->second);
        }
        text += '\n';
    }
    write_whole(file, text);
}

}  // namespace pendular::bench
