#include "reports/page/page_curves.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "data/grains.h"
#include "reports/model_curve.h"

namespace pendular {
namespace {

/// Number of points of a curve, and largest number of series with curves in a panel.
constexpr int points_of_curve = 9;
constexpr std::size_t most_curves = 8;
/// Largest ratio of two values of a quantity that count as one.
constexpr double alike_ratio = 1.08;

using OfCondition = std::function<double(const Condition&)>;

/// Ratio of the largest to the smallest value of a quantity over readings.
double spread(const std::vector<Reading>& readings, const std::vector<std::size_t>& members,
              const OfCondition& of) {
    double least = INFINITY, greatest = 0;
    for (const std::size_t k : members) {
        least = std::min(least, of(readings[k].condition));
        greatest = std::max(greatest, of(readings[k].condition));
    }
    return least > 0 ? greatest / least : 1;
}

/// Divides readings where a quantity jumps by more than `alike_ratio`.
std::vector<std::vector<std::size_t>> divided(const std::vector<Reading>& readings,
                                              std::vector<std::size_t> members,
                                              const OfCondition& of) {
    const auto value = [&](std::size_t k) { return of(readings[k].condition); };
    std::ranges::stable_sort(members, {}, value);
    std::vector<std::vector<std::size_t>> groups;
    for (const std::size_t k : members) {
        if (groups.empty() || value(k) > alike_ratio * value(groups.back().back())) {
            groups.emplace_back();
        }
        groups.back().push_back(k);
    }
    return groups;
}

/// Adds the points of a curve through the conditions of a series along the x axis.
void add_curve(PageSeries& series, const PagePanel& panel, const std::vector<Reading>& readings,
               const Coordinate& along, const OfCondition& x_of) {
    std::vector<Condition> conditions;
    for (const std::size_t k : series.members) {
        conditions.push_back(readings[k].condition);
    }
    const double from = panel.x[series.members.front()], to = panel.x[series.members.back()];
    if (!(to > alike_ratio * from) || !(from > 0)) return;
    const ConditionPath path(conditions, along);
    const double first = along.of(conditions.front()), last = along.of(conditions.back());
    for (int k = 0; k < points_of_curve; ++k) {
        const double part = static_cast<double>(k) / (points_of_curve - 1);
        const double at = panel.log_x && first > 0 ? first * std::pow(last / first, part)
                                                   : first + (last - first) * part;
        series.along.push_back(path.at(at));
        series.x.push_back(x_of(series.along.back()));
    }
}

/// Divides groups into steady readings and points of failure.
std::vector<std::vector<std::size_t>> divided_by_state(
    const std::vector<Reading>& readings, const std::vector<std::vector<std::size_t>>& groups) {
    std::vector<std::vector<std::size_t>> result;
    for (std::vector<std::size_t> group : groups) {
        const auto peaks = std::ranges::stable_partition(
            group, [&](std::size_t k) { return !readings[k].condition.at_failure; });
        const std::vector<std::size_t> failures(peaks.begin(), peaks.end());
        group.erase(peaks.begin(), peaks.end());
        if (!group.empty()) result.push_back(group);
        if (!failures.empty()) result.push_back(failures);
    }
    return result;
}

/// Panel of some readings with a series for each of `groups`, and apart for points of failure.
PagePanel panel_of(const std::vector<Reading>& readings,
                   const std::vector<std::vector<std::size_t>>& groups, PagePanel panel,
                   const Coordinate& along, const OfCondition& x_of,
                   const std::function<std::string(const Condition&)>& label) {
    panel.x.assign(readings.size(), std::numeric_limits<double>::quiet_NaN());
    for (std::vector<std::size_t> members : divided_by_state(readings, groups)) {
        for (const std::size_t k : members) {
            panel.x[k] = x_of(readings[k].condition);
        }
        std::ranges::stable_sort(members, {}, [&](std::size_t k) { return panel.x[k]; });
        const Condition& condition = readings[members.front()].condition;
        PageSeries series{
            .label = label(condition) + (condition.at_failure ? ", points of failure" : ""),
            .members = members,
            .x = {},
            .along = {}};
        if (panel.series.size() < most_curves) add_curve(series, panel, readings, along, x_of);
        panel.series.push_back(std::move(series));
    }
    return panel;
}

double stress_of(const Condition& c) {
    return c.normal_stress;
}
double inertial_number_of(const Condition& c) {
    return c.inertial_number;
}

PagePanel dry_panel(const std::vector<Reading>& readings, const std::vector<std::size_t>& dry) {
    const bool by_rate =
        spread(readings, dry, inertial_number_of) > spread(readings, dry, stress_of);
    if (by_rate) {
        return panel_of(readings, divided(readings, dry, stress_of),
                        {.title = "Dry readings",
                         .x_label = "inertial number I [1]",
                         .log_x = spread(readings, dry, inertial_number_of) > 5},
                        along_inertial_number, inertial_number_of, [](const Condition& c) {
                            return fmt::format("normal stress {:.3g} Pa", c.normal_stress);
                        });
    }
    return panel_of(readings, divided(readings, dry, inertial_number_of),
                    {.title = "Dry readings",
                     .x_label = "normal stress [Pa]",
                     .log_x = spread(readings, dry, stress_of) > 5},
                    along_inverse_normal_stress, stress_of, [](const Condition& c) {
                        return fmt::format("inertial number {:.2g}", c.inertial_number);
                    });
}

PagePanel wet_panel(const std::vector<Reading>& readings, const std::vector<std::size_t>& wet,
                    const Study& study) {
    std::vector<std::vector<std::size_t>> groups;
    for (const auto& content :
         divided(readings, wet, [](const Condition& c) { return c.liquid_content; })) {
        std::ranges::move(divided(readings, content, inertial_number_of),
                          std::back_inserter(groups));
    }
    const bool rates = spread(readings, wet, inertial_number_of) > alike_ratio;
    return panel_of(
        readings, groups, {.title = "Wet readings", .x_label = "1/P* [1]"},
        along_inverse_normal_stress,
        [&](const Condition& c) {
            return 1 / reduced_pressure(c.normal_stress, study.grains, *study.liquid);
        },
        [rates](const Condition& c) {
            return fmt::format("liquid content {:.3g}", c.liquid_content) +
                   (rates ? fmt::format(", inertial number {:.2g}", c.inertial_number) : "");
        });
}

}  // namespace

std::vector<PagePanel> page_panels(const std::vector<Reading>& readings, const Study& study) {
    std::vector<std::size_t> dry, wet;
    for (std::size_t k = 0; k < readings.size(); ++k) {
        (readings[k].condition.dry() ? dry : wet).push_back(k);
    }
    std::vector<PagePanel> panels;
    if (!dry.empty()) panels.push_back(dry_panel(readings, dry));
    if (!wet.empty() && study.liquid) panels.push_back(wet_panel(readings, wet, study));
    return panels;
}

}  // namespace pendular
