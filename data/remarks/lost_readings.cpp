#include "data/remarks/wording.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "data/recordings/step_series.h"

namespace pendular {
namespace {

using Kind = Remark::Kind;

/// Why a step gave no reading, without what is particular to one step, and advice.
struct Cause {
    std::string what, advice;
};

/// Cause for messages on many steps: `what` is a clause such as "the normal force is negative", to
/// be followed by "in all 30 steps"; empty for a remark that is not on a whole step.
Cause cause_without_reading(const Remark& step) {
    switch (step.kind) {
        case Kind::few_rows:
            return {fmt::format("less than {} rows were recorded", shortest_step), ""};
        case Kind::speed_ramp:
            return {"the speed of the lid changes",
                    "no steady shear: export steps of constant speed"};
        case Kind::back_and_forth:
            return {"the lid turns back and forth", "export steps of constant speed"};
        case Kind::at_rest:
            return {"the lid does not turn",
                    "check the column of the angular velocity, and its unit"};
        case Kind::short_strain:
        case Kind::short_steady_strain:
            return {"the strain is too small for steady shear",
                    fmt::format("steady shear takes a strain of {:g} (least_strain in [import]): "
                                "check the unit of the angular velocity, or record longer",
                                step.limit)};
        case Kind::never_steady:
            return {"torque or gap still change at the end", "record longer"};
        case Kind::few_steady_rows:
            return {fmt::format("less than {} rows are steady", shortest_step), "record longer"};
        case Kind::tension:
            return {"the normal force is negative",
                    "compression must be positive: reverse the sign of the column of the normal "
                    "force in the recordings"};
        case Kind::no_torque:
            return {"the torque is zero within its error",
                    "check that the torque was recorded, and its unit"};
        default:
            return {};
    }
}

/// Number of rows of recordings that a doubt set aside, whether or not they made readings.
std::size_t doubted(const Measurements& measurements) {
    std::set<std::pair<std::string, int>> rows;
    for (const Remark& doubt : measurements.with(Remark::Outcome::set_aside))
        for (const Lines& lines : doubt.lines)
            rows.emplace(doubt.files[lines.file], lines.first);
    return rows.size();
}

}  // namespace

std::size_t readings_set_aside(const Measurements& measurements) {
    const auto excluded = std::ranges::count_if(
        measurements.remarks, [](const Remark& remark) { return on_reading(remark.kind); });
    return std::max(static_cast<std::size_t>(excluded), doubted(measurements));
}

bool mostly_set_aside(const Measurements& measurements) {
    return readings_set_aside(measurements) > measurements.readings.size() ||
           (measurements.readings.empty() && !measurements.with(Remark::Outcome::left_out).empty());
}

std::optional<std::string> common_reason(const Measurements& measurements) {
    if (!mostly_set_aside(measurements)) return std::nullopt;
    struct Steps {
        std::size_t count = 0;
        const Remark* first = nullptr;
    };
    std::map<std::string, Steps> causes;
    std::size_t steps = 0;
    for (const Remark& each : measurements.remarks) {
        const Cause cause = cause_without_reading(each);
        if (cause.what.empty()) continue;
        ++steps;
        Steps& alike = causes[cause.what];
        if (alike.count++ == 0) alike.first = &each;
    }
    if (steps == 0) return std::nullopt;
    const Steps& most = std::ranges::max_element(causes, {}, [](const auto& cause) {
                            return cause.second.count;
                        })->second;
    if (doubted(measurements) >= most.count) return std::nullopt;  // the doubts say why
    if (steps == 1) return with_capital(text_of(*most.first)) + ".";
    const char* const which =
        measurements.readings.empty() ? "steps" : "steps that gave no reading";
    const std::string where = most.count == steps
                                  ? fmt::format("all {} {}", steps, which)
                                  : fmt::format("{} of {} {}", most.count, steps, which);
    const auto [what, advice] = cause_without_reading(*most.first);
    return fmt::format("{} in {}{}{}.", with_capital(what), where, advice.empty() ? "" : "; ",
                       advice);
}

std::string why_no_reading(const Measurements& measurements) {
    if (const auto doubts = measurements.with(Remark::Outcome::set_aside); !doubts.empty())
        return "Readings were set aside; the reason for the first: " + text_of(doubts.front());
    if (const auto reason = common_reason(measurements)) return *reason;
    const auto left_out = measurements.with(Remark::Outcome::left_out);
    return left_out.empty()
               ? "Give recordings or readings."
               : "All rows were left out; the reason for the first: " + text_of(left_out.front()) +
                     ".";
}

}  // namespace pendular
