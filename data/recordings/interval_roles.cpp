#include "data/recordings/interval_roles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <span>

#include "data/files/formats/layouts.h"
#include "data/quantities/statistics.h"
#include "data/recordings/column_kinds.h"
#include "data/recordings/lid_speed.h"
#include "data/recordings/plausibility.h"
#include "data/recordings/point_roles.h"
#include "data/recordings/step_series.h"
#include "data/recordings/steps.h"
#include "data/recordings/test_kinds.h"

namespace pendular {
namespace {

/// Loading of an interval, on which its role depends.
struct Loading {
    bool sheared = false;
    /// Whether a normal stress presses the sample, as in a test of grains: the shear stress is
    /// below three times the normal stress.
    bool pressed = false;
    bool has_speed = false;         ///< whether the speed of the lid is known
    double normal = 0;              ///< median normal stress or force
    std::optional<double> angle;    ///< angle by which the lid turned [rad], if known
    std::optional<SpeedRamp> ramp;  ///< speeds between which the lid's speed changed, if it did
    bool back_and_forth = false;    ///< whether the lid turned back and forth in each step
    bool relaxes = false;           ///< whether the lid rests and the shear never rises
    std::optional<std::string> load_ramp;  ///< as text, if the normal stress changed throughout
    std::optional<std::string> unsteady;   ///< as text, for stress growth or stick-slip
    std::size_t steps = 1;                 ///< of constant speed and load
    std::size_t rows = 0;
    bool has_time = false;
    const char* shear_word = "";  ///< name of the quantity that shows the shear
};

double largest_known(const std::vector<double>& values) {
    double largest = 0;
    for (const double value : values)
        if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
    return largest;
}

bool any_known(const std::vector<double>& values) {
    return std::ranges::any_of(values, [](double value) { return std::isfinite(value); });
}

/// Whether the lid turned during an interval; empty if no speed was recorded. Small torques do not
/// make a rest: at low normal stress, most of the torque may be a drag.
std::optional<bool> lid_turned(const IntervalSeries& series) {
    // A thirtieth of the turn up to which an interval counts as one to failure, and 0.15 mm at
    // 15 mm, less than a bead: chosen.
    constexpr double least_turn = 0.01;
    if (!any_known(series.angular_velocity)) return std::nullopt;
    if (const auto angle = angle_turned(series)) return *angle > least_turn;
    std::vector<double> speeds;
    std::ranges::copy_if(series.angular_velocity, std::back_inserter(speeds),
                         [](double speed) { return std::isfinite(speed); });
    return turns(speeds);
}

/// Whether the shear stress of an interval is one of sheared grains, where no speed was recorded.
bool stress_of_shear(const IntervalSeries& series, double normal) {
    // Half of the stress ratio of frictionless grains; see `least_stress_ratio`.
    if (!series.shear_stress.empty() && !series.normal_stress.empty())
        return largest_known(series.shear()) > least_stress_ratio * std::abs(normal);
    // Torque and force alone tell no stress ratio: the torque of that ratio on the smallest plates,
    // of 4 mm radius, on which a uniform stress acts at 2/3 of the radius.
    constexpr double least_arm = 2.0 / 3 * 4e-3;
    return largest_known(series.shear()) > least_stress_ratio * least_arm * std::abs(normal);
}

/// Whether any interval of a file shows that the lid turned. A file in which it never does, such
/// as one that rounds slow speeds to 0, says nothing by its speeds.
bool speeds_tell(const std::vector<IntervalSeries>& series) {
    return std::ranges::any_of(
        series, [](const IntervalSeries& each) { return lid_turned(each).value_or(false); });
}

/// Whether the lid turns at constant speed in one of several steps of an interval, as in a
/// staircase of speeds, of which a study reads each step.
bool turns_at_constant_speed(const IntervalSeries& series, const std::vector<Step>& steps) {
    const std::span<const double> speeds = series.angular_velocity;
    return steps.size() > 1 && std::ranges::any_of(steps, [&](const Step& step) {
               const auto all = speeds.subspan(step.begin, step.end - step.begin);
               const auto at_speed = all.subspan(begin_at_speed(all));
               return at_speed.size() >= shortest_step && !varying_speed(all) && turns(at_speed);
           });
}

/// Whether the lid turns back and forth in each step of an interval in which it moves.
bool back_and_forth(const IntervalSeries& series, const std::vector<Step>& steps) {
    const auto known = [&](const std::vector<double>& column) {
        return column.size() == series.size() &&
               std::ranges::all_of(column, [](double value) { return std::isfinite(value); });
    };
    if (series.size() == 0 || !known(series.time) || !known(series.angular_velocity)) return false;
    std::size_t reversals = 0;
    for (const auto& [begin, end] : steps) {
        const auto speeds = std::span(series.angular_velocity).subspan(begin, end - begin);
        const bool reverses =
            turns_back_and_forth(speeds, std::span(series.time).subspan(begin, end - begin));
        if (!reverses && turns(speeds)) return false;
        reversals += reverses;
    }
    return reversals > 0;
}

/// Whether a shear stress or torque never rises above that of its first rows, as one that relaxes.
/// Shear to failure begins with less than its peak.
bool never_rises(const std::vector<double>& shear) {
    // Chosen: medians of three rows of noise seldom differ by more.
    constexpr double least_rise = 0.1;
    constexpr std::size_t parts = 20, fewest_of_part = 3, fewest_rows = 10;
    std::vector<double> known;
    for (const double each : shear)
        if (std::isfinite(each)) known.push_back(std::abs(each));
    if (known.size() < fewest_rows) return false;
    const std::size_t part = std::max(known.size() / parts, fewest_of_part);
    const auto level = [&](std::size_t begin) {
        const auto from = known.begin() + static_cast<std::ptrdiff_t>(begin);
        return median({from, from + static_cast<std::ptrdiff_t>(part)});
    };
    const double first = level(0);
    for (std::size_t begin = part; begin + part <= known.size(); begin += part)
        if (level(begin) > (1 + least_rise) * first) return false;
    return true;
}

std::vector<Loading> loadings(const std::vector<IntervalSeries>& series) {
    constexpr double most_ratio = 3;  // `greatest_stress_ratio` at P* = 1
    const bool by_speed = speeds_tell(series);
    std::vector<Loading> result;
    for (const IntervalSeries& each : series) {
        Loading loading;
        loading.normal = median_of_known(each.normal());
        const auto turned = by_speed ? lid_turned(each) : std::nullopt;
        loading.sheared = turned ? *turned : stress_of_shear(each, loading.normal);
        const bool stresses = !each.shear_stress.empty() && !each.normal_stress.empty();
        loading.pressed = loading.normal > 0 &&
                          (!stresses || largest_known(each.shear()) < most_ratio * loading.normal);
        loading.has_speed = any_known(each.angular_velocity) || any_known(each.shear_velocity);
        loading.angle = angle_turned(each);
        const std::vector<Step> steps = steps_of(each);
        if (!turns_at_constant_speed(each, steps)) {
            loading.ramp = varying_speed(each.angular_velocity);
            loading.back_and_forth = back_and_forth(each, steps);
        }
        loading.relaxes = !lid_turned(each).value_or(true) && never_rises(each.shear());
        loading.load_ramp = load_ramp(each);
        loading.unsteady = stress_growth(each);
        if (!loading.unsteady) loading.unsteady = stick_slip(each);
        loading.steps = steps.size();
        loading.rows = each.size();
        loading.has_time = any_known(each.time);
        loading.shear_word = shear_word(each);
        result.push_back(loading);
    }
    return result;
}

/// Whether the numbers of a test's intervals are 4, 8, 12 and so on, with the others left out.
bool only_every_fourth(const std::vector<Block>& blocks) {
    return blocks.size() > 1 && std::ranges::all_of(blocks, [](const Block& block) {
               return block.number > 0 && block.number % 4 == 0;
           });
}

/// Index of the sheared interval of the same test before (`step` -1) or after (+1) an interval.
std::optional<std::size_t> sheared_neighbour(const BlockFile& file,
                                             const std::vector<Loading>& loading, std::size_t i,
                                             int step) {
    for (std::size_t k = i + static_cast<std::size_t>(step); k < loading.size();
         k += static_cast<std::size_t>(step)) {
        if (file.blocks[k].test != file.blocks[i].test) return std::nullopt;
        if (loading[k].sheared && loading[k].pressed) return k;
    }
    return std::nullopt;
}

/// Next sheared interval of the test whose normal stress differs from that of interval `i` by more
/// than 5 %; empty if there is none.
std::optional<std::size_t> next_level(const BlockFile& file, const std::vector<Loading>& loading,
                                      std::size_t i) {
    auto next = sheared_neighbour(file, loading, i, +1);
    while (next && std::abs(loading[*next].normal / loading[i].normal - 1) < 0.05)
        next = sheared_neighbour(file, loading, *next, +1);
    return next;
}

// Turns of the lid [rad], chosen: 1 is a strain of 1 at a height equal to the mean radius, as
// `ImportSettings::least_strain` asks by default.
constexpr double long_turn = 1, short_turn = 0.3;

IntervalRole steady_shear(const Loading& own) {
    const std::string steps =
        own.steps > 1 ? fmt::format(" in {} steps of constant speed and load", own.steps) : "";
    const std::string few =
        own.has_time && own.rows < shortest_step
            ? fmt::format("; too few rows for a study, which needs {}", shortest_step)
            : "";
    if (own.angle && *own.angle > long_turn)
        return {"steady", fmt::format("the lid turned by {:.2g} rad{}{}", *own.angle, steps, few)};
    return {"steady", "sheared" + (steps.empty() ? " at constant set points" : steps) + few};
}

IntervalRole role_of_sheared(const BlockFile& file, const std::vector<Loading>& loading,
                             std::size_t i) {
    constexpr double higher = 1.05;  // as stresses of two steps differ (steps.cpp)
    const Loading& own = loading[i];
    if (own.back_and_forth)
        return {"other", "the lid turns back and forth, as in oscillation: no steady shear"};
    if (own.relaxes)
        return {"other", fmt::format("the lid does not turn, and the {} does not rise: rest or "
                                     "relaxation, no failure",
                                     own.shear_word)};
    if (own.ramp)
        return {"other", fmt::format("the speed of the lid changes {}, and none lasts {} rows: no "
                                     "steady shear",
                                     own.ramp->change(), shortest_step)};

    if (!own.pressed) return {"steady", "sheared, but not under a normal stress as grains are"};
    if (own.angle && *own.angle > long_turn && own.load_ramp) return {"other", *own.load_ramp};
    if (own.angle && *own.angle > long_turn && own.unsteady) return {"other", *own.unsteady};
    if (own.angle && *own.angle > long_turn) return steady_shear(own);
    const auto before = sheared_neighbour(file, loading, i, -1);
    const auto after = next_level(file, loading, i);
    if (only_every_fourth(file.blocks))
        return {"failure", "only intervals 4, 8, 12 ... of a powder cell's test were exported"};
    if (before && loading[*before].normal > higher * own.normal)
        return {"failure",
                fmt::format("normal stress {:.2f} times that of interval {} before it",
                            own.normal / loading[*before].normal, file.blocks[*before].number)};
    if (after && own.normal > higher * loading[*after].normal)
        return {"preshear",
                fmt::format("normal stress {:.2f} times that of interval {} after it",
                            own.normal / loading[*after].normal, file.blocks[*after].number)};
    if (own.angle && *own.angle < short_turn)
        return {"failure", fmt::format("the lid turned by {:.2g} rad, too little for steady shear",
                                       *own.angle)};
    if (own.load_ramp) return {"other", *own.load_ramp};
    if (own.unsteady) return {"other", *own.unsteady};
    if (!own.has_speed) return {"steady", "sheared; the speed of the lid is not known"};
    return steady_shear(own);
}

IntervalRole role_of_resting(const BlockFile& file, const std::vector<Loading>& loading,
                             std::size_t i) {
    const auto before = sheared_neighbour(file, loading, i, -1);
    if (!before) return {"filling", "without shear, before the first sheared interval"};
    const bool lower = loading[i].normal < 0.95 * loading[*before].normal;
    return {lower ? "unloading" : "reloading", "without shear, between sheared intervals"};
}

}  // namespace

std::optional<double> angle_turned(const IntervalSeries& series) {
    if (series.time.empty() || series.angular_velocity.empty() || series.size() < 2)
        return std::nullopt;
    double angle = 0;
    for (std::size_t i = 1; i < series.size(); ++i) {
        const double part = std::abs(series.angular_velocity[i]) *
                            std::max(series.time[i] - series.time[i - 1], 0.0);
        if (std::isfinite(part)) angle += part;
    }
    return angle;
}

double median_of_known(const std::vector<double>& values) {
    std::vector<double> known;
    for (const double value : values)
        if (std::isfinite(value)) known.push_back(value);
    return known.empty() ? std::numeric_limits<double>::quiet_NaN() : median(known);
}

std::vector<IntervalRole> roles_of(const BlockFile& file, const std::vector<IntervalSeries>& series,
                                   const FileFormat& format) {
    const std::vector<Loading> loading = loadings(series);
    const std::vector<bool> impossible = impossible_points(file, series);
    std::vector<IntervalRole> roles;
    for (std::size_t i = 0; i < series.size(); ++i) {
        if (const std::string stated = stated_role(file.blocks[i], format); !stated.empty())
            roles.push_back({stated, "stated by the user"});
        else if (!impossible[i] && !file.blocks[i].stated_role.empty())
            roles.push_back({file.blocks[i].stated_role, "stated by the file"});
        else if (const auto kind = kind_shown_by_columns(file.blocks[i]))
            roles.push_back({"other", *kind});
        else if (impossible[i])
            roles.push_back(
                {"other", "a stress that stands for no value beside those of the other points"});
        else if (const std::string shown =
                     file.shown_wall.empty() ? named_wall(file.blocks[i]) : file.shown_wall;
                 !shown.empty() && (file.table_of_points || loading[i].sheared))
            roles.push_back({"wall", fmt::format("shear along a wall, as {} shows", shown)});
        else if (file.table_of_points)
            roles.push_back(
                {"failure", is_stated_failure(file.blocks[i])
                                ? "a point of failure, as its column failure says"
                                : "a table of points: one row is one test, taken for a peak"});
        else if (largest_known(series[i].normal()) == 0 || !any_known(series[i].shear()))
            roles.push_back({"other", "no values of shear stress or of normal stress"});
        else if (!loading[i].sheared)
            roles.push_back(role_of_resting(file, loading, i));
        else
            roles.push_back(role_of_sheared(file, loading, i));
    }
    return roles;
}

}  // namespace pendular
