#include "data/recordings/checks.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

#include "data/quantities/statistics.h"

namespace pendular {
namespace {

using Kind = Remark::Kind;

/// Largest relative differences [1] of a row, beside what the resolution allows, and of a common
/// factor of all rows. The former is that of `check_ratio`; the latter is what radii of a cell of
/// 21 and 45 mm change if they are rounded to half a millimetre.
constexpr double row_tolerance = 0.05, factor_tolerance = 0.02;

/// Two columns of one recording that hold the same quantity, in SI units.
struct ColumnPair {
    std::string quantity;               ///< name of the stated quantity, "shear_stress"
    const std::vector<double>& values;  ///< values of the stated column; NaN where a cell is empty
    std::vector<double> computed;       ///< values computed from the measured column
    double tolerance;                   ///< difference that the resolution of both columns allows
};

std::vector<double> scaled(const std::vector<double>& values, double factor) {
    std::vector<double> result = values;
    for (double& value : result)
        value *= factor;
    return result;
}

ColumnPair pair_of(const char* quantity, const std::vector<double>& values,
                   const std::vector<double>& measured, double factor) {
    std::vector<double> known;
    std::ranges::copy_if(values, std::back_inserter(known),
                         [](double v) { return std::isfinite(v); });
    const double resolved = least_step(known) + factor * least_step(measured);
    return {quantity, values, scaled(measured, factor),
            // Columns with few distinct values resolve little: at most half of the median.
            std::min(resolved, 0.5 * std::abs(median(known)))};
}

std::vector<ColumnPair> pairs_of(const Recording& recording, const AnnularCell& cell) {
    std::vector<ColumnPair> pairs;
    if (!recording.shear_stress.empty())
        pairs.push_back(pair_of("shear_stress", recording.shear_stress, recording.torque,
                                shear_stress(1, cell)));
    if (!recording.normal_stress.empty())
        pairs.push_back(pair_of("normal_stress", recording.normal_stress, recording.normal_force,
                                normal_stress(1, cell)));
    if (!recording.shear_rate.empty()) {
        ColumnPair rate =
            pair_of("shear_rate", recording.shear_rate, recording.angular_velocity, 1);
        for (std::size_t i = 0; i < recording.size(); ++i)
            rate.computed[i] = shear_rate(recording.angular_velocity[i], recording.height[i], cell);
        rate.tolerance = 0;
        pairs.push_back(std::move(rate));
    }
    return pairs;
}

/// Whether the two values of a row are known and far enough from zero to be compared.
bool comparable(const ColumnPair& pair, std::size_t i) {
    const double stated = std::abs(pair.values[i]), computed = std::abs(pair.computed[i]);
    return std::isfinite(stated) && std::max(stated, computed) > 5 * pair.tolerance && computed > 0;
}

/// Indices of the rows whose stated value differs from the computed value times a factor.
std::vector<std::size_t> rows_off(const ColumnPair& pair, double factor) {
    std::vector<std::size_t> rows;
    for (std::size_t i = 0; i < pair.values.size(); ++i) {
        if (!comparable(pair, i)) continue;
        const double expected = factor * std::abs(pair.computed[i]);
        const double difference = std::abs(std::abs(pair.values[i]) - expected);
        if (difference > row_tolerance * expected + pair.tolerance) rows.push_back(i);
    }
    return rows;
}

/// Compares one pair of columns, and marks the rows that contradict each other.
void judge(const ColumnPair& pair, const Recording& recording, std::vector<Remark>& found,
           std::vector<bool>& rows) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < pair.values.size(); ++i)
        if (comparable(pair, i)) ratios.push_back(std::abs(pair.values[i] / pair.computed[i]));
    if (ratios.size() < shortest_step) return;
    const double factor = median(ratios);
    const bool common = std::abs(factor - 1) > factor_tolerance;
    const std::vector<std::size_t> off = rows_off(pair, common ? factor : 1);
    Remark remark{.quantity = pair.quantity, .count = off.size(), .of = ratios.size()};
    if (common && factor > 0) {
        const bool other_radius = pair.quantity == "shear_rate" && factor > 0.5 && factor < 2;
        remark.kind = other_radius ? Kind::rate_at_other_radius : Kind::wrong_factor;
        remark.size = factor;
        remark.add({recording.file, recording.line.front(), 0});
        found.push_back(std::move(remark));
    } else if (!off.empty()) {
        remark.kind = Kind::contradicting_rows;
        remark.size = std::abs(pair.values[off.front()] / pair.computed[off.front()]);
        remark.limit = factor;
        remark.add({recording.file, recording.line[off.front()], 0});
        Remark& all = remark.because.emplace_back();
        for (const std::size_t i : off) {
            rows[i] = true;
            add_line(all.lines, recording.line[i]);
        }
        found.push_back(std::move(remark));
    }
}

/// Adds the marked rows, neighbouring rows as one range.
void add_rows(const Recording& recording, const std::vector<bool>& rows,
              std::vector<Remark>& found) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (!rows[i]) continue;
        if (i > 0 && rows[i - 1])
            found.back().lines.front().last = recording.line[i];
        else
            found.push_back({.kind = Kind::contradicting_row,
                             .files = {recording.file},
                             .lines = {{recording.line[i], recording.line[i]}}});
    }
}

}  // namespace

std::vector<Remark> contradictions(const Recording& recording, const AnnularCell& cell,
                                   std::vector<bool>& rows) {
    std::vector<Remark> found;
    rows.assign(recording.size(), false);
    for (const ColumnPair& pair : pairs_of(recording, cell))
        judge(pair, recording, found, rows);
    add_rows(recording, rows, found);
    return found;
}

}  // namespace pendular
