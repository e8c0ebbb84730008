#include "data/recordings/findings/finding.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "data/recordings/robust.h"

namespace pendular {
namespace {

using Kind = RecordingFinding::Kind;

/// Findings that one sentence describes.
using Group = std::vector<const RecordingFinding*>;

bool alike(const RecordingFinding& a, const RecordingFinding& b) {
    const bool wobble = a.kind == Kind::wobble;
    return a.kind == b.kind && a.quantity == b.quantity && (!wobble || a.period == b.period);
}

std::vector<Group> groups_of(const std::vector<RecordingFinding>& findings, bool all) {
    std::vector<Group> groups;
    for (const RecordingFinding& each : findings) {
        const auto same = std::ranges::find_if(
            groups, [&](const Group& group) { return alike(*group.front(), each); });
        all || same == groups.end() ? groups.push_back({&each}) : same->push_back(&each);
    }
    std::ranges::stable_sort(groups, {}, [](const Group& group) { return group.front()->kind; });
    return groups;
}

std::string words_for(const std::string& quantity) {
    if (quantity == "normal_force") return "normal force";
    return quantity == "height" ? "gap" : quantity;
}

std::string with_unit(const std::string& quantity, double value) {
    const bool force = quantity == "normal_force";
    const char* const unit = force ? "N" : quantity == "height" ? "mm" : "mN m";
    const double shown = force ? value : 1e3 * value;
    return std::abs(shown) < 100 ? fmt::format("{:.2g} {}", shown, unit)
                                 : fmt::format("{:.0f} {}", shown, unit);
}

template <typename Member>
double usual(const Group& group, Member member) {
    std::vector<double> values;
    for (const RecordingFinding* each : group)
        values.push_back(each->*member);
    return median(std::move(values));
}

std::string name_of(const std::string& file) {
    return std::filesystem::path(file).filename().string();
}

/// Text with the steps of a group: "step 3 of dry_1.csv" or "12 steps of 3 files, first step 1 of
/// dry_1.csv".
std::string places(const Group& group) {
    const RecordingFinding& first = *group.front();
    std::size_t steps = 0;
    std::set<std::string> files;
    for (const RecordingFinding* each : group) {
        steps += each->count;
        files.insert(each->files.begin(), each->files.end());
    }
    const std::string file = name_of(first.files.front());
    const std::string place = first.step > 0 ? fmt::format("step {} of {}", first.step, file)
                                             : fmt::format("in {}", file);
    if (steps == 1) return place;
    if (files.size() == 1) return fmt::format("{} steps of {}", steps, file);
    return fmt::format("{} steps of {} files, first {}", steps, files.size(), place);
}

std::string p_text(const Group& group) {
    double p = 1;
    for (const RecordingFinding* each : group)
        p = std::min(p, each->p);
    return p < 1e-3 ? "p < 0.001" : fmt::format("p = {:.1g}", p);
}

/// Size with its unit and in per cent: "0.03 mm (0.5 %)".
std::string size_text(const Group& group) {
    return fmt::format("{} ({:.2g} %)",
                       with_unit(group.front()->quantity, usual(group, &RecordingFinding::size)),
                       100 * usual(group, &RecordingFinding::relative));
}

std::string saturation_text(const Group& group) {
    const RecordingFinding& first = *group.front();
    return fmt::format(
        "Saturation: the {} stands at its largest value, {}, in {:.0f} % of the rows of {}. {}",
        words_for(first.quantity), with_unit(first.quantity, first.size),
        100 * usual(group, &RecordingFinding::relative), places(group),
        first.corrected ? "These rows are not used as if they were true."
                        : "The true values are larger.");
}

std::string level_text(const Group& group) {
    const RecordingFinding& first = *group.front();
    const double percent = 100 * std::abs(first.relative);
    const std::string change =
        first.offset ? fmt::format("{} (about {:.2g} %)",
                                   with_unit(first.quantity, std::abs(first.size)), percent)
                     : fmt::format("{:.3g} +- {:.1g} %", percent, 100 * first.relative_error);
    return fmt::format(
        "A step between recordings: from {} on, the {} at comparable conditions is {} {} than "
        "before ({} recordings, {}). Was the lid remounted, or the instrument changed?",
        name_of(first.files.front()), words_for(first.quantity), change,
        first.relative > 0 ? "larger" : "smaller", first.count, p_text(group));
}

std::string wobble_text(const Group& group) {
    const RecordingFinding& first = *group.front();
    const bool corrected = std::ranges::any_of(group, &RecordingFinding::corrected);
    return fmt::format("Wobble: the {} varies by +-{} {} per turn of the lid in {} ({}).{}",
                       words_for(first.quantity), size_text(group),
                       first.period == 1 ? "once" : "twice", places(group), p_text(group),
                       corrected ? " Readings that it affects are averaged over whole turns." : "");
}

std::string stick_slip_text(const Group& group) {
    return fmt::format("Stick-slip: the torque drops suddenly by {} every {:.2g} s in {} ({}).",
                       size_text(group), usual(group, &RecordingFinding::period), places(group),
                       p_text(group));
}

std::string drift_text(const Group& group) {
    const RecordingFinding& first = *group.front();
    return fmt::format(
        "Drift: the {} {} by {:.2g} +- {:.1g} % within a step, after its transient, on average "
        "over {} ({}). Look for wear, or for a loss of liquid or beads.",
        words_for(first.quantity), first.relative > 0 ? "rises" : "falls",
        100 * std::abs(first.relative), 100 * first.relative_error, places(group), p_text(group));
}

std::string run_in_text(const Group& group) {
    return fmt::format(
        "Run-in: at the end of the step the {} is still {} from its level in {} ({}). Shear "
        "longer.",
        words_for(group.front()->quantity), size_text(group), places(group), p_text(group));
}

std::string sentence(const Group& group) {
    switch (group.front()->kind) {
        case Kind::saturation:
            return saturation_text(group);
        case Kind::level_change:
            return level_text(group);
        case Kind::wobble:
            return wobble_text(group);
        case Kind::stick_slip:
            return stick_slip_text(group);
        case Kind::drift:
            return drift_text(group);
        case Kind::unfinished_run_in:
            return run_in_text(group);
    }
    return "";
}

}  // namespace

std::string_view to_string(Kind kind) {
    switch (kind) {
        case Kind::saturation:
            return "saturation";
        case Kind::level_change:
            return "level-change";
        case Kind::wobble:
            return "wobble";
        case Kind::stick_slip:
            return "stick-slip";
        case Kind::drift:
            return "drift";
        case Kind::unfinished_run_in:
            return "unfinished-run-in";
    }
    return "";
}

std::vector<std::string> sentences(const std::vector<RecordingFinding>& findings, bool all) {
    std::vector<std::string> result;
    for (const Group& group : groups_of(findings, all))
        result.push_back(sentence(group));
    return result;
}

}  // namespace pendular
