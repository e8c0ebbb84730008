#include "reports/page/page_curves.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <numbers>

#include "data/annular_cell.h"
#include "data/grains.h"
#include "data/quantities/number.h"
#include "reports/model_curve.h"

namespace pendular {
namespace {

/// Number of points of a curve, and largest number of series with curves in a panel. Chosen: models
/// are smooth along a panel, and more curves would cover each other.
constexpr int points_of_one_curve = 9;
constexpr std::size_t most_curves = 12;
/// Largest ratio of two values of a quantity that count as one. Chosen: above the 2 % of
/// replicates, below the steps of a series.
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

/// Whether readings at one place along the x axis have other beads or heights, so that no
/// curve through their mean passes them.
bool mixed(const std::vector<Reading>& readings, const std::vector<std::size_t>& members,
           const Coordinate& along) {
    const auto differ = [](double a, double b) {
        return std::abs(a - b) > (alike_ratio - 1) / 2 * std::max(std::abs(a), std::abs(b));
    };
    for (const std::size_t j : members) {
        for (const std::size_t k : members) {
            const Condition &a = readings[j].condition, &b = readings[k].condition;
            if (differ(along.of(a), along.of(b))) continue;
            if (differ(a.bead_volume.value_or(0), b.bead_volume.value_or(0)) ||
                differ(a.height.value_or(0), b.height.value_or(0)))
                return true;
        }
    }
    return false;
}

/// Part of a series of readings, and what tells it from the others; empty if it is the only one.
struct CurvePart {
    std::vector<std::size_t> members;
    std::string label = {};
};

/// Divides readings that are mixed by the mass of the beads, or else by file.
std::vector<CurvePart> divided_if_mixed(const std::vector<Reading>& readings,
                                        const std::vector<std::size_t>& members, const Study& study,
                                        const Coordinate& along) {
    if (!mixed(readings, members, along)) return {{members}};
    const auto volume = [](const Condition& c) { return c.bead_volume.value_or(0); };
    std::vector<CurvePart> parts;
    for (const auto& group : divided(readings, members, volume)) {
        const double mass = 1e3 * study.grains.density * volume(readings[group[0]].condition);
        parts.push_back({group, fmt::format("{:.4g} g of beads", mass)});
    }
    if (std::ranges::none_of(
            parts, [&](const CurvePart& part) { return mixed(readings, part.members, along); })) {
        return parts;
    }
    std::map<std::string, CurvePart> by_file;
    for (const std::size_t k : members) {
        const std::string& file = readings[k].origin.file;
        by_file[file].label = std::filesystem::path(file).filename().string();
        by_file[file].members.push_back(k);
    }
    parts.clear();
    for (auto& [file, part] : by_file) {
        parts.push_back(std::move(part));
    }
    return parts;
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
    for (int k = 0; k < points_of_one_curve; ++k) {
        const double part = static_cast<double>(k) / (points_of_one_curve - 1);
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

/// Differences between the series of a panel: `value`, a quantity that has `label` in words, and
/// the `group`; an empty text where all readings are in one group.
struct Lanes {
    OfCondition value;
    std::function<std::string(const Condition&)> label;
    std::function<std::string(const Condition&)> group = [](const Condition&) { return ""; };
};

/// Texts that are not empty, with commas between them.
std::string listed(const std::vector<std::string>& texts) {
    std::string line;
    for (const std::string& text : texts) {
        if (!text.empty()) line += (line.empty() ? "" : ", ") + text;
    }
    return line;
}

/// Panel of some readings with a series for each of `groups`, and apart for points of failure.
PagePanel panel_of(const std::vector<Reading>& readings, const Study& study,
                   const std::vector<std::vector<std::size_t>>& groups, PagePanel panel,
                   const Coordinate& along, const OfCondition& x_of, const Lanes& lanes) {
    panel.x.assign(readings.size(), std::numeric_limits<double>::quiet_NaN());
    for (const std::vector<std::size_t>& group : divided_by_state(readings, groups)) {
        for (CurvePart& part : divided_if_mixed(readings, group, study, along)) {
            for (const std::size_t k : part.members) {
                panel.x[k] = x_of(readings[k].condition);
            }
            std::ranges::stable_sort(part.members, {}, [&](std::size_t k) { return panel.x[k]; });
            const Condition& c = readings[part.members.front()].condition;
            const std::string state = c.at_failure ? "points of failure" : "";
            PageSeries series{.label = listed({lanes.group(c), lanes.label(c), part.label, state}),
                              .group = listed({lanes.group(c), part.label, state}),
                              .value = lanes.value(c),
                              .members = part.members,
                              .x = {},
                              .along = {}};
            if (panel.series.size() < most_curves) add_curve(series, panel, readings, along, x_of);
            panel.series.push_back(std::move(series));
        }
    }
    return panel;
}

double normal_stress_of(const Condition& c) {
    return c.normal_stress;
}
double inertial_number_of(const Condition& c) {
    return c.inertial_number;
}

/// Quantity that the rheometer held constant while the normal stress changed: inertial number, or
/// speed of the lid.
struct Held {
    OfCondition of;
    std::function<std::string(const Condition&)> label;
    std::string quantity;  ///< name and unit
};

Held held_inertial_number() {
    return {inertial_number_of,
            [](const Condition& c) { return "inertial number " + nominal_text(c.inertial_number); },
            "inertial number [1]"};
}

/// Speed of the lid where the cell and the heights are known, otherwise the shear rate.
Held held_speed(const std::vector<Reading>& readings, const Study& study) {
    const GrainProperties grains = study.grains;
    const auto rate = [grains](const Condition& c) {
        return shear_rate_at(c.inertial_number, c.normal_stress, grains);
    };
    const bool by_lid = study.cell && std::ranges::all_of(readings, [](const Reading& r) {
                            return r.condition.height.has_value();
                        });
    if (!by_lid) {
        return {rate,
                [rate](const Condition& c) {
                    return fmt::format("shear rate {} 1/s", nominal_text(rate(c)));
                },
                "shear rate [1/s]"};
    }
    constexpr double per_minute = 60 / (2 * std::numbers::pi);
    const auto speed = [rate, cell = *study.cell](const Condition& c) {
        return per_minute * angular_velocity(rate(c), *c.height, cell);
    };
    return {speed, [speed](const Condition& c) { return nominal_text(speed(c)) + " rpm"; },
            "speed of the lid [rpm]"};
}

/// The quantity that divides readings into fewer series: the inertial number, unless the speed
/// does.
Held held_constant(const std::vector<Reading>& readings, const std::vector<std::size_t>& members,
                   const Study& study) {
    const Held inertial = held_inertial_number(), speed = held_speed(readings, study);
    return divided(readings, members, speed.of).size() <
                   divided(readings, members, inertial.of).size()
               ? speed
               : inertial;
}

/// Whether the inertial number is the better x axis: it varies by the larger factor and has no more
/// series than the normal stress.
bool by_rate(const std::vector<Reading>& readings, const std::vector<std::size_t>& members,
             const Held& held) {
    return spread(readings, members, inertial_number_of) >
               spread(readings, members, normal_stress_of) &&
           divided(readings, members, normal_stress_of).size() <=
               divided(readings, members, held.of).size();
}

std::string normal_stress_label(const Condition& c) {
    return fmt::format("normal stress {} Pa", nominal_text(c.normal_stress));
}

PagePanel dry_panel(const std::vector<Reading>& readings, const std::vector<std::size_t>& dry,
                    const Study& study) {
    const Held held = held_constant(readings, dry, study);
    if (by_rate(readings, dry, held)) {
        return panel_of(readings, study, divided(readings, dry, normal_stress_of),
                        {.title = "Dry readings",
                         .x_label = "inertial number I [1]",
                         .log_x = spread(readings, dry, inertial_number_of) > 5,
                         .quantity = "normal stress [Pa]"},
                        along_inertial_number, inertial_number_of,
                        {.value = normal_stress_of, .label = normal_stress_label});
    }
    return panel_of(readings, study, divided(readings, dry, held.of),
                    {.title = "Dry readings",
                     .x_label = "normal stress [Pa]",
                     .log_x = spread(readings, dry, normal_stress_of) > 5,
                     .quantity = held.quantity},
                    along_inverse_normal_stress, normal_stress_of,
                    {.value = held.of, .label = held.label});
}

std::string content_label(const Condition& c) {
    return fmt::format("liquid content {:.3g}", c.liquid_content);
}

/// Differences between series of wet readings: the liquid content and, if several, the values of
/// `of`.
Lanes lanes_of_wet(const OfCondition& of, bool several,
                   const std::function<std::string(const Condition&)>& label) {
    return {.value = of,
            .label = [several, label](const Condition& c) { return several ? label(c) : ""; },
            .group = content_label};
}

PagePanel wet_panel(const std::vector<Reading>& readings, const std::vector<std::size_t>& wet,
                    const Study& study) {
    const Held held = held_constant(readings, wet, study);
    const bool rates = by_rate(readings, wet, held);
    const OfCondition of = rates ? normal_stress_of : held.of;
    std::vector<std::vector<std::size_t>> groups;
    for (const auto& content :
         divided(readings, wet, [](const Condition& c) { return c.liquid_content; })) {
        std::ranges::move(divided(readings, content, of), std::back_inserter(groups));
    }
    const bool several = spread(readings, wet, of) > alike_ratio;
    if (rates) {
        return panel_of(readings, study, groups,
                        {.title = "Wet readings",
                         .x_label = "inertial number I [1]",
                         .log_x = spread(readings, wet, inertial_number_of) > 5,
                         .quantity = "normal stress [Pa]"},
                        along_inertial_number, inertial_number_of,
                        lanes_of_wet(of, several, normal_stress_label));
    }
    return panel_of(
        readings, study, groups,
        {.title = "Wet readings", .x_label = "1/P* [1]", .quantity = held.quantity},
        along_inverse_normal_stress,
        [&](const Condition& c) {
            return 1 / reduced_pressure(c.normal_stress, study.grains, *study.liquid);
        },
        lanes_of_wet(of, several, held.label));
}

}  // namespace

std::vector<Condition> points_of_curves(const std::vector<PagePanel>& panels) {
    std::vector<Condition> points;
    for (const PagePanel& panel : panels) {
        for (const PageSeries& series : panel.series) {
            points.insert(points.end(), series.along.begin(), series.along.end());
        }
    }
    return points;
}

std::vector<PagePanel> page_panels(const std::vector<Reading>& readings, const Study& study) {
    std::vector<std::size_t> dry, wet;
    for (std::size_t k = 0; k < readings.size(); ++k) {
        (readings[k].condition.dry() ? dry : wet).push_back(k);
    }
    std::vector<PagePanel> panels;
    if (!dry.empty()) panels.push_back(dry_panel(readings, dry, study));
    if (!wet.empty() && study.liquid) panels.push_back(wet_panel(readings, wet, study));
    return panels;
}

}  // namespace pendular
