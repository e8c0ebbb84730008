#include "data/recordings/contradictions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include "data/recordings/plausibility.h"
#include "data/recordings/robust.h"

namespace pendular {
namespace {

constexpr double row_tolerance = 0.05, factor_tolerance = 0.02;

/// Two columns of one recording that hold the same quantity, in SI units.
struct ColumnPair {
    std::string stated, measured;       ///< words for the columns: "shear stress", "torque"
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

ColumnPair pair_of(const char* stated, const char* measured, const char* quantity,
                   const std::vector<double>& values, const std::vector<double>& measured_values,
                   double factor) {
    std::vector<double> known;
    std::ranges::copy_if(values, std::back_inserter(known),
                         [](double v) { return std::isfinite(v); });
    const double resolved = least_step(known) + factor * least_step(measured_values);
    return {stated, measured, quantity, values, scaled(measured_values, factor),
            // Columns with few distinct values resolve little: at most half of the median.
            std::min(resolved, 0.5 * std::abs(median(known)))};
}

std::vector<ColumnPair> pairs_of(const Recording& recording, const AnnularCell& cell) {
    std::vector<ColumnPair> pairs;
    if (!recording.shear_stress.empty())
        pairs.push_back(pair_of("shear stress", "torque", "shear_stress", recording.shear_stress,
                                recording.torque, shear_stress(1, cell)));
    if (!recording.normal_stress.empty())
        pairs.push_back(pair_of("normal stress", "normal force", "normal_stress",
                                recording.normal_stress, recording.normal_force,
                                normal_stress(1, cell)));
    if (!recording.shear_rate.empty()) {
        ColumnPair rate = pair_of("shear rate", "angular velocity", "shear_rate",
                                  recording.shear_rate, recording.angular_velocity, 1);
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

/// Text with the likely cause of a constant factor between a stated and a computed column.
std::string cause_of(const ColumnPair& pair, double factor) {
    const auto is = [&](double other) { return std::abs(factor / other - 1) < factor_tolerance; };
    if (pair.quantity == "shear_stress" && (is(2) || is(0.5)))
        return "the printed torque formula gives twice the derived one: see torque_formula in "
               "[cell]";
    const double power = std::round(std::log10(factor));
    if (power != 0 && is(std::pow(10, power)))
        return fmt::format(
            "a factor of 10^{:.0f}: check the units of both columns{}", power,
            pair.quantity == "shear_stress"
                ? "; if only some torques lost a mark, repair = true in [[recording]] takes them "
                  "from the shear stress"
                : "");
    if (pair.quantity == "shear_rate" && (is(2 * M_PI) || is(0.5 / M_PI)))
        return "a factor of 2 pi: turns per second read as radians per second or the reverse";
    return "check inner_radius and outer_radius in [cell]: the instrument used others, or another "
           "formula";
}

/// Compares one pair of columns, and adds doubts and notes to `result`. With `aside`, adds
/// contradicting rows to `rows` and sets `file` to the reason if the whole file is doubtful.
void judge(const ColumnPair& pair, const Recording& recording, bool aside, Measurements& result,
           std::set<std::size_t>& rows, std::optional<std::string>& file) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < pair.values.size(); ++i)
        if (comparable(pair, i)) ratios.push_back(std::abs(pair.values[i] / pair.computed[i]));
    if (ratios.size() < shortest_step) return;
    const double factor = median(ratios);
    const bool common = std::abs(factor - 1) > factor_tolerance;
    const std::vector<std::size_t> off = rows_off(pair, common ? factor : 1);
    const Position origin{recording.file, recording.line.front(), 0};
    if (common && factor > 0) {
        const std::string what = fmt::format(
            "the column of the {} is {:.4g} times what the {} gives with the study's cell (median "
            "of {} rows, {:.0f} % of them agree); {}",
            pair.stated, factor, pair.measured, ratios.size(),
            100 - 100.0 * static_cast<double>(off.size()) / static_cast<double>(ratios.size()),
            cause_of(pair, factor));
        // Instruments may state the rate at another radius than the mean, such as the rim.
        if (pair.quantity == "shear_rate" && factor > 0.5 && factor < 2) {
            result.notes.push_back(
                fmt::format("{}: {}; the rate at the mean radius is used", recording.file, what));
            return;
        }
        result.doubts.push_back(
            {fmt::format("{}: {}.", recording.file, what), pair.quantity, {origin}, aside});
        if (aside && !file) file = what;
        return;
    }
    if (off.empty()) return;
    std::vector<double> wrong;
    for (const std::size_t i : off)
        wrong.push_back(std::abs(pair.values[i] / pair.computed[i]));
    result.doubts.push_back(
        {fmt::format(
             "{}: {} and {} contradict each other in {} of {} rows, first in line {}, where "
             "the {} is {:.3g} times what the {} gives; elsewhere they agree (median ratio "
             "{:.4g}). Check whether cells of one of the columns are corrupt.",
             recording.file, pair.stated, pair.measured, off.size(), ratios.size(),
             recording.line[off.front()], pair.stated, wrong.front(), pair.measured, factor),
         pair.quantity,
         {{recording.file, recording.line[off.front()], 0}},
         aside});
    if (aside) rows.insert(off.begin(), off.end());
}

/// Adds rows to `result.excluded`, neighbouring rows as one range.
void exclude_rows(const Recording& recording, const std::set<std::size_t>& rows,
                  Measurements& result) {
    for (auto at = rows.begin(); at != rows.end();) {
        const std::size_t first = *at;
        std::size_t last = first;
        while (++at != rows.end() && *at == last + 1)
            last = *at;
        result.excluded.push_back({{recording.file, recording.line[first], 0},
                                   recording.line[last],
                                   "set aside: the columns of a row contradict each other"});
    }
}

}  // namespace

Contradictions take_out_contradictions(Recording& recording, const AnnularCell& cell,
                                       const ImportSettings& choice, Measurements& result) {
    Contradictions found{.averaged_rows = recording.averaged_rows};
    std::set<std::size_t> rows;
    for (const ColumnPair& pair : pairs_of(recording, cell))
        judge(pair, recording, !choice.keep_implausible, result, rows, found.file);
    if (rows.empty()) return found;
    exclude_rows(recording, rows, result);
    std::vector<bool> marked(recording.size(), false);
    for (const std::size_t row : rows) {
        marked[row] = true;
        found.lines.insert(recording.line[row]);
    }
    erase_rows(recording, marked);
    return found;
}

void set_aside_contradicted(const Contradictions& contradictions, Measurements& part) {
    std::vector<Reading> kept;
    for (const Reading& reading : part.readings) {
        const auto& lines = contradictions.lines;
        const auto spoilt = std::distance(lines.lower_bound(reading.origin.line),
                                          lines.upper_bound(reading.last_line));
        const int rows =
            (reading.last_line - reading.origin.line) / contradictions.averaged_rows + 1;
        if (contradictions.file)
            part.excluded.push_back(left_out(reading, "set aside: " + *contradictions.file));
        else if (100 * spoilt > rows)
            part.excluded.push_back(left_out(
                reading, fmt::format("set aside: step {}: its columns contradict each other in {} "
                                     "of {} rows",
                                     reading.step, spoilt, rows)));
        else
            kept.push_back(reading);
    }
    part.readings = std::move(kept);
}

}  // namespace pendular
