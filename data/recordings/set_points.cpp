#include "data/recordings/checks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>

#include "data/quantities/number.h"
#include "data/quantities/statistics.h"
#include "data/quantities/units.h"

namespace pendular {
namespace {

constexpr std::size_t shortest_stretch = 20;  ///< rows, as `shortest_step`
/// Largest relative difference of a measured median from its set point [1], as between replicates.
constexpr double follow_tolerance = 0.02;

/// Numbers of a column as the file writes them; NaN where a cell is no number.
std::vector<double> numbers_of(const Block& block, std::size_t column) {
    std::vector<double> numbers;
    for (const Row& row : block.table.rows)
        numbers.push_back(parse_number(row.cells[column].text)
                              .value_or(std::numeric_limits<double>::quiet_NaN()));
    return numbers;
}

/// Factor from the unit of one column to that of another; empty if the units do not fit.
std::optional<double> factor_between(const std::string& from, const std::string& to) {
    if (from == to || from.empty()) return 1;  // a set point without a unit has that of the column
    try {
        const Unit unit(from), other(to);
        if (!unit.same_dimension(other)) return std::nullopt;
        return (unit.to_si(1) - unit.to_si(0)) / (other.to_si(1) - other.to_si(0));
    } catch (const std::invalid_argument&) {
        return std::nullopt;
    }
}

/// Stretches of constant set point of a quantity, with those that missed it.
struct Followed {
    std::size_t stretches = 0, missed = 0;
    std::vector<Lines> lines;  ///< of the stretches whose set point was missed
    double worst = 0, measured = 0,
           set = 0;  ///< relative deviation, and values where it is largest
    std::string unit;
};

/// Compares one stretch, rows [begin, end), of constant set point.
void compare_stretch(const Block& block, const std::vector<double>& measured, double set,
                     std::size_t begin, std::size_t end, Followed& followed) {
    if (end - begin < shortest_stretch || set == 0) return;
    std::vector<double> values;
    for (std::size_t i = begin + (end - begin) / 2; i < end; ++i)
        if (std::isfinite(measured[i])) values.push_back(measured[i]);
    if (values.size() < shortest_stretch / 2) return;
    ++followed.stretches;
    const double usual = median(values), deviation = std::abs(usual) / std::abs(set) - 1;
    const double resolution = 2 * least_step(values) / std::abs(set);
    if (std::abs(deviation) <= std::max(follow_tolerance, resolution)) return;
    ++followed.missed;
    followed.lines.push_back({block.table.rows[begin].line, block.table.rows[end - 1].line});
    if (std::abs(deviation) <= std::abs(followed.worst)) return;
    followed.worst = deviation;
    followed.measured = usual;
    followed.set = set;
}

void compare_columns(const Block& block, std::size_t measured, std::size_t set,
                     Followed& followed) {
    const std::string& unit = block.columns[measured].unit;
    const auto factor = factor_between(block.columns[set].unit, unit);
    if (!factor) return;
    followed.unit = unit;
    const std::vector<double> values = numbers_of(block, measured);
    std::vector<double> points = numbers_of(block, set);
    for (double& point : points)
        point *= *factor;
    for (std::size_t begin = 0; begin < points.size();) {
        std::size_t end = begin + 1;
        while (end < points.size() &&
               std::abs(points[end] - points[begin]) <= 1e-3 * std::abs(points[begin]))
            ++end;
        compare_stretch(block, values, points[begin], begin, end, followed);
        begin = end;
    }
}

}  // namespace

std::vector<Remark> missed_set_points(const BlockFile& file) {
    std::map<std::string, Followed> by_quantity;
    for (const Block& block : file.blocks)
        for (std::size_t set = 0; set < block.columns.size(); ++set) {
            const std::string& name = block.columns[set].set_point_of;
            if (name.empty()) continue;
            const auto measured = std::ranges::find(block.columns, name, &BlockColumn::quantity);
            if (measured == block.columns.end()) continue;
            compare_columns(block, static_cast<std::size_t>(measured - block.columns.begin()), set,
                            by_quantity[name]);
        }
    std::vector<Remark> faults;
    for (const auto& [name, followed] : by_quantity)
        if (followed.missed > 0)
            faults.push_back({.kind = Remark::Kind::missed_set_point,
                              .quantity = name,
                              .files = {file.file},
                              .lines = followed.lines,
                              .count = followed.missed,
                              .of = followed.stretches,
                              .size = followed.measured,
                              .limit = followed.set,
                              .relative = followed.worst,
                              .names = {followed.unit}});
    return faults;
}

}  // namespace pendular
