#include "data/recordings/common_reason.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <utility>

namespace pendular {
namespace {

std::string capitalised(std::string text) {
    if (!text.empty())
        text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
    return text;
}

/// Rows of recordings that a doubt set aside, whether or not they made readings.
std::size_t doubted(const Measurements& measurements) {
    std::set<std::pair<std::string, int>> rows;
    for (const Doubt& doubt : measurements.doubts) {
        if (!doubt.set_aside) continue;
        for (const Position& origin : doubt.origins)
            rows.emplace(origin.file, origin.line);
    }
    return rows.size();
}

}  // namespace

std::size_t readings_set_aside(const Measurements& measurements) {
    const auto excluded =
        std::ranges::count(measurements.excluded, Excluded::Kind::reading, &Excluded::kind);
    return std::max(static_cast<std::size_t>(excluded), doubted(measurements));
}

bool mostly_set_aside(const Measurements& measurements) {
    return readings_set_aside(measurements) > measurements.readings.size() ||
           (measurements.readings.empty() && !measurements.excluded.empty());
}

std::optional<std::string> common_reason(const Measurements& measurements) {
    if (!mostly_set_aside(measurements)) return std::nullopt;
    struct Steps {
        std::size_t count = 0;
        const Excluded* first = nullptr;
    };
    std::map<std::string, Steps> causes;
    std::size_t steps = 0;
    for (const Excluded& each : measurements.excluded) {
        if (each.cause.what.empty()) continue;
        ++steps;
        Steps& cause = causes[each.cause.what];
        if (cause.count++ == 0) cause.first = &each;
    }
    if (steps == 0) return std::nullopt;
    const Steps& most = std::ranges::max_element(causes, {}, [](const auto& cause) {
                            return cause.second.count;
                        })->second;
    if (doubted(measurements) >= most.count) return std::nullopt;  // the doubts say why
    if (steps == 1) return capitalised(most.first->reason) + ".";
    const char* const which =
        measurements.readings.empty() ? "steps" : "steps that gave no reading";
    const std::string where = most.count == steps
                                  ? fmt::format("all {} {}", steps, which)
                                  : fmt::format("{} of {} {}", most.count, steps, which);
    const Excluded::Cause& cause = most.first->cause;
    return fmt::format("{} in {}{}{}.", capitalised(cause.what), where,
                       cause.advice.empty() ? "" : "; ", cause.advice);
}

std::string why_no_reading(const Measurements& measurements) {
    const auto doubt = std::ranges::find_if(measurements.doubts, &Doubt::set_aside);
    if (doubt != measurements.doubts.end())
        return "Readings were set aside; the reason for the first: " + doubt->what;
    if (const auto reason = common_reason(measurements)) return *reason;
    return measurements.excluded.empty() ? "Give recordings or readings."
                                         : "All rows were left out; the reason for the first: " +
                                               measurements.excluded.front().reason + ".";
}

}  // namespace pendular
