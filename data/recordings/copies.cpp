#include "data/recordings/copies.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "data/quantities/statistics.h"

namespace pendular {
namespace {

using Kind = Remark::Kind;

/// Smallest number of distinct torques in a run of copied rows: rows of few torques, as in a coarse
/// column, agree by chance.
constexpr std::size_t fewest_torques = 5;
/// Approximate number of rows from which the offset in time of a copy is estimated. Chosen: equal
/// offsets of so many rows stand out, and the time does not grow with the recording.
constexpr std::size_t sampled_rows = 64;

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
    Stretch result{.file = recording.file,
                   .line = part(recording.line),
                   .time = part(recording.time),
                   .torque = part(recording.torque),
                   .normal_force = part(recording.normal_force),
                   .height = part(recording.height),
                   .liquid_content = source.liquid_content,
                   .bead_volume = source.bead_volume};
    const auto range = [](const std::vector<double>& values) {
        const auto [least, most] = std::ranges::minmax(values);
        return Stretch::Range{least, most, least_step(values)};
    };
    result.of_torque = range(result.torque);
    result.of_force = range(result.normal_force);
    result.of_height = range(result.height);
    result.spacing = usual_spacing(result.time);
    result.by_torque = ordered(result.torque);
    for (const std::size_t row : result.by_torque)
        result.sorted_torque.push_back(result.torque[row]);
    return result;
}

double KnownRows::copy_tolerance(const Stretch::Range& a, const Stretch::Range& b) {
    const double largest =
        std::max({std::abs(a.least), std::abs(a.most), std::abs(b.least), std::abs(b.most)});
    // A constant column does not show its resolution.
    if (a.resolution == 0 || b.resolution == 0) return 0.01 * largest;
    return 0.5 * std::max(a.resolution, b.resolution) * (1 + 1e-6) + 1e-9 * largest;
}

bool KnownRows::may_repeat(const Stretch& later, const Stretch& earlier) {
    const auto overlap = [](const Stretch::Range& a, const Stretch::Range& b) {
        const double tolerance = copy_tolerance(a, b);
        return a.least <= b.most + tolerance && b.least <= a.most + tolerance;
    };
    return overlap(later.of_torque, earlier.of_torque) &&
           overlap(later.of_force, earlier.of_force) && overlap(later.of_height, earlier.of_height);
}

std::vector<double> KnownRows::likely_offsets(const Stretch& later, const Stretch& earlier) {
    const double torque = copy_tolerance(later.of_torque, earlier.of_torque),
                 force = copy_tolerance(later.of_force, earlier.of_force),
                 height = copy_tolerance(later.of_height, earlier.of_height);
    const std::vector<double>& torques = earlier.sorted_torque;
    const std::size_t stride = std::max<std::size_t>(1, later.size() / sampled_rows);
    std::vector<double> offsets;
    for (std::size_t i = 0; i < later.size(); i += stride) {
        for (auto at = std::ranges::lower_bound(torques, later.torque[i] - torque);
             at != torques.end() && *at <= later.torque[i] + torque; ++at) {
            const std::size_t row =
                earlier.by_torque[static_cast<std::size_t>(at - torques.begin())];
            if (std::abs(earlier.normal_force[row] - later.normal_force[i]) <= force &&
                std::abs(earlier.height[row] - later.height[i]) <= height)
                offsets.push_back(later.time[i] - earlier.time[row]);
        }
    }
    if (offsets.empty()) return {};
    return {0, densest(offsets, 0.5 * earlier.spacing)};
}

KnownRows::Matches KnownRows::matches_at(const Stretch& later, const Stretch& earlier,
                                         double offset) {
    const double torque = copy_tolerance(later.of_torque, earlier.of_torque),
                 force = copy_tolerance(later.of_force, earlier.of_force),
                 height = copy_tolerance(later.of_height, earlier.of_height),
                 time = 0.25 * std::min(later.spacing, earlier.spacing);
    // A window of +-`time` has one row at most where rows are evenly spaced.
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
                       const std::vector<Step>& runs, std::vector<Remark>& found) {
    Remark note{.kind = Kind::copied_file,
                .files = {earlier.file, later.file},
                .count = 0,
                .of = later.size()};
    for (const Step& run : runs) {
        note.count += run.end - run.begin;
        found.push_back({.kind = Kind::copied_rows,
                         .files = {later.file, earlier.file},
                         .lines = {{later.line[run.begin], later.line[run.end - 1]},
                                   {earlier.line[*matches[run.begin]],
                                    earlier.line[*matches[run.end - 1]], 1}}});
    }
    found.push_back(std::move(note));
    const bool other_content = later.liquid_content != earlier.liquid_content;
    const int line = later.line[runs.front().begin];
    if (other_content || later.bead_volume != earlier.bead_volume)
        found.push_back({.kind = Kind::restated_copy,
                         .quantity = other_content ? "liquid_content" : "bead_volume",
                         .files = {later.file},
                         .lines = {{line, line}},
                         .names = {earlier.file}});
}

std::vector<Remark> KnownRows::copies_in(const Recording& recording, const Source& source,
                                         std::vector<bool>& copied) {
    std::vector<Remark> found;
    copied.assign(recording.size(), false);
    for (const Step& rows : stretches_of_time(recording.time)) {
        if (rows.end - rows.begin < shortest_step) continue;
        Stretch later = stretch(recording, rows, source);
        for (const Stretch& earlier : known_) {
            if (!may_repeat(later, earlier)) continue;
            const Matches matches = repeated_rows(later, earlier);
            const std::vector<Step> runs = runs_of(matches, later);
            if (runs.empty()) continue;
            report(later, earlier, matches, runs, found);
            for (const Step& run : runs)
                std::fill(copied.begin() + static_cast<std::ptrdiff_t>(rows.begin + run.begin),
                          copied.begin() + static_cast<std::ptrdiff_t>(rows.begin + run.end), true);
            break;
        }
        known_.push_back(std::move(later));
    }
    return found;
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

std::vector<Remark> repeated_readings(const std::vector<Reading>& readings) {
    std::vector<Remark> found;
    std::vector<const Reading*> kept;
    std::map<std::pair<std::string, std::string>, std::size_t> copies;  // by original and copy
    for (const Reading& reading : readings) {
        const auto earlier = std::ranges::find_if(
            kept, [&](const Reading* other) { return repeats(*other, reading); });
        if (earlier == kept.end()) {
            kept.push_back(&reading);
            continue;
        }
        ++copies[{(*earlier)->origin.file, reading.origin.file}];
        found.push_back(reading.remark(Kind::repeated_reading));
        found.back().add((*earlier)->origin);
    }
    for (const auto& [files, number] : copies) {
        Remark& note = found.emplace_back(
            Remark{.kind = Kind::copied_readings, .files = {files.first}, .count = number});
        if (files.first != files.second) note.files.push_back(files.second);
    }
    return found;
}

}  // namespace pendular
