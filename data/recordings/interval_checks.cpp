#include "data/recordings/interval_checks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "data/quantities/number.h"
#include "data/recordings/interval_roles.h"
#include "data/recordings/nines.h"
#include "data/recordings/point_roles.h"
#include "data/recordings/spikes.h"
#include "data/recordings/steps.h"

namespace pendular {
namespace {

using Kind = Remark::Kind;

/// Column of measured values in a block, in the unit of the file.
struct MeasuredColumn {
    std::size_t index = 0;
    std::vector<std::size_t> rows = {};  ///< those with a number
    std::vector<double> values = {};
};

bool is_measured(std::string_view quantity) {
    constexpr std::array<std::string_view, 9> names = {
        "torque",         "normal_force", "height",        "angular_velocity", "rotational_speed",
        "shear_velocity", "shear_stress", "normal_stress", "lever_force"};
    return std::ranges::find(names, quantity) != names.end();
}

MeasuredColumn column_of(const Block& block, std::size_t index) {
    MeasuredColumn column{.index = index};
    for (std::size_t i = 0; i < block.table.rows.size(); ++i)
        if (const auto value = parse_number(block.table.rows[i].cells[index].text)) {
            column.rows.push_back(i);
            column.values.push_back(*value);
        }
    return column;
}

/// Magnitude [unit of the file] that 95 % of the values do not exceed.
double usual_most(std::vector<double> values) {
    for (double& value : values)
        value = std::abs(value);
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(0.95 * (std::ssize(values) - 1));
    std::ranges::nth_element(values, at);
    return *at;
}

/// Indices without those of successive rows that are as many as a step has: a load of 999 Pa.
std::vector<std::size_t> without_steps(const std::vector<std::size_t>& places) {
    std::vector<std::size_t> result;
    for (std::size_t begin = 0, end = 0; begin < places.size(); begin = end) {
        for (end = begin + 1; end < places.size() && places[end] == places[end - 1] + 1;)
            ++end;
        if (end - begin < shortest_step)
            result.insert(result.end(), places.begin() + static_cast<std::ptrdiff_t>(begin),
                          places.begin() + static_cast<std::ptrdiff_t>(end));
    }
    return result;
}

std::vector<std::size_t> far_in(const std::vector<double>& values) {
    constexpr double above_usual = 1.5;  // less changes what is told of a file by little
    if (values.empty()) return {};
    if (std::vector<std::size_t> marks = without_steps(marks_of_nines(values)); !marks.empty())
        return marks;
    const double least = above_usual * usual_most(values);
    if (std::ranges::none_of(values, [&](double value) { return std::abs(value) > least; }))
        return {};
    std::vector<std::size_t> found = spikes(values);
    std::erase_if(found, [&](std::size_t i) { return !(std::abs(values[i]) > least); });
    return found;
}

/// Adds the far values of one column of a block to the remark on the column of all blocks.
void add_far_values(const Block& block, std::size_t index, std::vector<Remark>& found) {
    const MeasuredColumn column = column_of(block, index);
    const std::vector<std::size_t> far = far_in(column.values);
    if (far.empty()) return;
    const BlockColumn& head = block.columns[index];
    auto remark = std::ranges::find_if(
        found, [&](const Remark& each) { return each.quantity == head.quantity; });
    if (remark == found.end())
        remark = found.insert(
            found.end(),
            {.kind = Kind::far_values,
             .quantity = head.quantity,
             .files = {block.table.file},
             .count = 0,
             .size = column.values[far.front()],
             .corrected = !is_of_nines(column.values[far.front()]),
             .names = {block.table.rows[column.rows[far.front()]].cells[index].text, head.unit}});
    for (const std::size_t i : far)
        add_line(remark->lines, block.table.rows[column.rows[i]].line);
    remark->count += far.size();
}

/// Whether all loads are one, told in a pass: the search for steps takes many.
bool has_one_load(const std::vector<double>& loads) {
    if (loads.empty()) return true;
    const auto [least, greatest] = std::ranges::minmax(loads);
    return is_same_load(least, greatest);
}

/// Number of times that the largest load returns after a lower one; 0 where no two lower loads
/// differ, or lower ones follow one another.
std::size_t returns_of_largest(const std::vector<double>& loads) {
    const double largest = *std::ranges::max_element(loads);
    std::size_t returns = 0;
    bool others_differ = false;
    double lower = 0;
    for (std::size_t i = 0; i < loads.size(); ++i) {
        const bool is_largest = is_same_load(loads[i], largest);
        if (is_largest == (i % 2 == 1)) return 0;
        if (is_largest)
            returns += i > 0;
        else if (lower > 0)
            others_differ |= !is_same_load(loads[i], lower);
        else
            lower = loads[i];
    }
    return others_differ ? returns : 0;
}

}  // namespace

std::vector<Remark> far_values(const BlockFile& file) {
    std::vector<Remark> found;
    if (file.table_of_points) return found;
    for (const Block& block : file.blocks)
        for (std::size_t i = 0; i < block.columns.size(); ++i)
            if (is_measured(block.columns[i].quantity) && !block.columns[i].of_errors)
                add_far_values(block, i, found);
    return found;
}

std::vector<Remark> cycles_in_one_interval(const BlockFile& file,
                                           const std::vector<IntervalSeries>& series) {
    constexpr double long_turn = 1;  // as for the roles of intervals
    std::vector<Remark> found;
    for (const IntervalSeries& each : series) {
        if (has_one_load(each.normal())) continue;
        const std::vector<Step> steps = steps_of(each);
        const auto angle = angle_turned(each);
        if (steps.size() < 4 || !angle || *angle >= long_turn * static_cast<double>(steps.size()))
            continue;
        std::vector<double> loads;
        for (const auto& [begin, end] : steps)
            loads.push_back(median_of_known(each.rows(begin, end).normal()));
        const std::size_t returns = returns_of_largest(loads);
        if (returns == 0) continue;
        found.push_back({.kind = Kind::cycles_in_one_interval,
                         .files = {file.file},
                         .lines = {{each.line.front(), each.line.back()}},
                         .count = returns,
                         .of = steps.size()});
    }
    return found;
}

}  // namespace pendular
