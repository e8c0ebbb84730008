#include "data/recordings/copies.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "data/recordings/plausibility.h"
#include "data/recordings/robust.h"

namespace pendular {
namespace {

/// Smallest number of distinct torques in a run of copied rows.
constexpr std::size_t fewest_torques = 5;
/// Approximate number of rows from which the offset in time of a copy is estimated.
constexpr std::size_t sampled_rows = 64;

/// Largest difference between two columns, in their unit, if one is a copy of the other, perhaps
/// rounded: half the resolution of the coarser column; 1 % of the largest value if a column is
/// constant.
double copy_tolerance(const std::vector<double>& a, const std::vector<double>& b) {
    const double step_a = least_step(a), step_b = least_step(b);
    const auto size = [](double x, double y) { return std::max(std::abs(x), std::abs(y)); };
    double largest = 0;
    for (const auto* values : {&a, &b}) {
        const auto [least, most] = std::ranges::minmax(*values);
        largest = std::max(largest, size(least, most));
    }
    if (step_a == 0 || step_b == 0) return 0.01 * largest;
    return 0.5 * std::max(step_a, step_b) * (1 + 1e-6) + 1e-9 * largest;
}

/// Median time between neighbouring rows with different times [s].
double usual_spacing(const std::vector<double>& time) {
    std::vector<double> spacings;
    for (std::size_t i = 1; i < time.size(); ++i)
        if (time[i] > time[i - 1]) spacings.push_back(time[i] - time[i - 1]);
    return median(std::move(spacings));
}

/// Splits rows where the time restarts.
std::vector<Step> stretches_of_time(const std::vector<double>& time) {
    std::vector<Step> stretches;
    std::size_t begin = 0;
    for (std::size_t i = 1; i <= time.size(); ++i) {
        if (i < time.size() && time[i] >= time[i - 1]) continue;
        stretches.push_back({begin, i});
        begin = i;
    }
    return stretches;
}

/// Median of the values in the interval of a given width that contains the most values.
double densest(std::vector<double> values, double width) {
    std::ranges::sort(values);
    std::size_t best = 0, most = 0;
    for (std::size_t begin = 0, end = 0; begin < values.size(); ++begin) {
        while (end < values.size() && values[end] <= values[begin] + width)
            ++end;
        if (end - begin <= most) continue;
        most = end - begin;
        best = begin;
    }
    return values[best + most / 2];
}

/// Indices of the values in ascending order of the values.
std::vector<std::size_t> ordered(const std::vector<double>& values) {
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, [&](std::size_t i) { return values[i]; });
    return order;
}

}  // namespace

KnownRows::Stretch KnownRows::stretch(const Recording& recording, const Step& rows,
                                      const Source& source) {
    const auto part = [&](const auto& all) {
        return std::vector(all.begin() + static_cast<std::ptrdiff_t>(rows.begin),
                           all.begin() + static_cast<std::ptrdiff_t>(rows.end));
    };
    return {recording.file,
            part(recording.line),
            part(recording.time),
            part(recording.torque),
            part(recording.normal_force),
            part(recording.height),
            source.liquid_content,
            source.bead_volume};
}

std::vector<double> KnownRows::likely_offsets(const Stretch& later, const Stretch& earlier) {
    const double torque = copy_tolerance(later.torque, earlier.torque),
                 force = copy_tolerance(later.normal_force, earlier.normal_force),
                 height = copy_tolerance(later.height, earlier.height);
    const std::vector<std::size_t> order = ordered(earlier.torque);
    const std::size_t stride = std::max<std::size_t>(1, later.size() / sampled_rows);
    std::vector<double> offsets;
    for (std::size_t i = 0; i < later.size(); i += stride) {
        const auto torque_of = [&](std::size_t row) { return earlier.torque[row]; };
        for (auto at = std::ranges::lower_bound(order, later.torque[i] - torque, {}, torque_of);
             at != order.end() && earlier.torque[*at] <= later.torque[i] + torque; ++at) {
            if (std::abs(earlier.normal_force[*at] - later.normal_force[i]) <= force &&
                std::abs(earlier.height[*at] - later.height[i]) <= height)
                offsets.push_back(later.time[i] - earlier.time[*at]);
        }
    }
    if (offsets.empty()) return {};
    return {0, densest(offsets, 0.5 * usual_spacing(earlier.time))};
}

KnownRows::Matches KnownRows::matches_at(const Stretch& later, const Stretch& earlier,
                                         double offset) {
    const double torque = copy_tolerance(later.torque, earlier.torque),
                 force = copy_tolerance(later.normal_force, earlier.normal_force),
                 height = copy_tolerance(later.height, earlier.height),
                 time = 0.25 * std::min(usual_spacing(later.time), usual_spacing(earlier.time));
    Matches matches(later.size());
    for (std::size_t i = 0; i < later.size(); ++i) {
        const double wanted = later.time[i] - offset;
        for (auto at = std::ranges::lower_bound(earlier.time, wanted - time);
             at != earlier.time.end() && *at <= wanted + time && !matches[i]; ++at) {
            const auto row = static_cast<std::size_t>(at - earlier.time.begin());
            if (std::abs(earlier.torque[row] - later.torque[i]) <= torque &&
                std::abs(earlier.normal_force[row] - later.normal_force[i]) <= force &&
                std::abs(earlier.height[row] - later.height[i]) <= height)
                matches[i] = row;
        }
    }
    return matches;
}

std::vector<Step> KnownRows::runs_of(const Matches& matches, const Stretch& later) {
    std::vector<Step> runs;
    for (std::size_t begin = 0; begin < matches.size();) {
        if (!matches[begin]) {
            ++begin;
            continue;
        }
        std::size_t end = begin;
        std::set<double> torques;
        while (end < matches.size() && matches[end])
            torques.insert(later.torque[end++]);
        if (end - begin >= shortest_step && torques.size() >= fewest_torques)
            runs.push_back({begin, end});
        begin = end;
    }
    return runs;
}

KnownRows::Matches KnownRows::repeated_rows(const Stretch& later, const Stretch& earlier) {
    Matches best;
    std::size_t most = 0;
    for (const double offset : likely_offsets(later, earlier)) {
        Matches matches = matches_at(later, earlier, offset);
        std::size_t rows = 0;
        for (const Step& run : runs_of(matches, later))
            rows += run.end - run.begin;
        if (rows <= most) continue;
        most = rows;
        best = std::move(matches);
    }
    return best;
}

void KnownRows::report(const Stretch& later, const Stretch& earlier, const Matches& matches,
                       const std::vector<Step>& runs, Measurements& result) {
    std::size_t rows = 0;
    for (const Step& run : runs) {
        rows += run.end - run.begin;
        result.excluded.push_back(
            {{later.file, later.line[run.begin], 0},
             later.line[run.end - 1],
             fmt::format("repeats {}, lines {} to {}; the same measurement counts once",
                         earlier.file, earlier.line[*matches[run.begin]],
                         earlier.line[*matches[run.end - 1]])});
    }
    result.notes.push_back(
        fmt::format("{} and {} hold the same measurement, {} of {} rows: it counts once, as {}",
                    earlier.file, later.file, rows, later.size(), earlier.file));
    if (later.liquid_content != earlier.liquid_content || later.bead_volume != earlier.bead_volume)
        result.doubts.push_back(
            {fmt::format("{}: these are the measurements of {}, but the study states another "
                         "liquid_content or bead mass for them; remove the wrong one.",
                         later.file, earlier.file),
             later.liquid_content != earlier.liquid_content ? "liquid_content" : "bead_volume",
             {{later.file, later.line[runs.front().begin], 0}},
             true});
}

void KnownRows::take_out_copies(Recording& recording, const Source& source, Measurements& result) {
    std::vector<bool> copied(recording.size(), false);
    for (const Step& rows : stretches_of_time(recording.time)) {
        if (rows.end - rows.begin < shortest_step) continue;
        const Stretch later = stretch(recording, rows, source);
        for (const Stretch& earlier : known_) {
            const Matches matches = repeated_rows(later, earlier);
            const std::vector<Step> runs = runs_of(matches, later);
            if (runs.empty()) continue;
            report(later, earlier, matches, runs, result);
            for (const Step& run : runs)
                std::fill(copied.begin() + static_cast<std::ptrdiff_t>(rows.begin + run.begin),
                          copied.begin() + static_cast<std::ptrdiff_t>(rows.begin + run.end), true);
            break;
        }
        known_.push_back(later);
    }
    erase_rows(recording, copied);
}

namespace {

bool nearly(double a, double b) {
    return std::abs(a - b) <= 1e-9 * std::max(std::abs(a), std::abs(b));
}

/// Whether a value has more than six significant digits, more than tables written by hand have.
bool many_digits(double value) {
    return !nearly(value, std::stod(fmt::format("{:.6g}", value)));
}

bool same_filling(const Condition& a, const Condition& b) {
    return !a.bead_volume || !b.bead_volume || nearly(*a.bead_volume, *b.bead_volume);
}

bool repeats(const Reading& a, const Reading& b) {
    const bool same_values = nearly(a.condition.normal_stress, b.condition.normal_stress) &&
                             nearly(a.value(0), b.value(0)) && nearly(a.value(1), b.value(1)) &&
                             nearly(a.condition.inertial_number, b.condition.inertial_number) &&
                             nearly(a.condition.liquid_content, b.condition.liquid_content) &&
                             same_filling(a.condition, b.condition);
    if (!same_values) return false;
    if (nearly(a.condition.time, b.condition.time) && a.covariance.isApprox(b.covariance, 1e-9))
        return true;
    return a.origin.file != b.origin.file && many_digits(a.value(0)) && many_digits(a.value(1));
}

}  // namespace

void count_readings_once(Measurements& measurements) {
    std::vector<Reading> kept;
    std::map<std::pair<std::string, std::string>, int> copies;  // by original and copy
    for (const Reading& reading : measurements.readings) {
        const auto earlier = std::ranges::find_if(
            kept, [&](const Reading& other) { return repeats(other, reading); });
        if (earlier == kept.end()) {
            kept.push_back(reading);
            continue;
        }
        ++copies[{earlier->origin.file, reading.origin.file}];
        measurements.excluded.push_back(
            left_out(reading, fmt::format("repeats {}; the same measurement counts once",
                                          to_string(earlier->origin))));
    }
    measurements.readings = std::move(kept);
    for (const auto& [files, number] : copies)
        measurements.notes.push_back(
            files.first == files.second
                ? fmt::format("{}: readings that repeat an earlier one in all digits: {}; each "
                              "counts once",
                              files.first, number)
                : fmt::format("{} and {} hold the same readings, {} of them: they count once, as "
                              "{}",
                              files.first, files.second, number, files.first));
}

}  // namespace pendular
