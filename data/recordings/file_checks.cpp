#include "data/recordings/file_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "data/quantities/statistics.h"
#include "data/recordings/checks.h"
#include "data/recordings/interval_roles.h"
#include "data/recordings/stated_cell.h"

namespace pendular {
namespace {

using Kind = Remark::Kind;

/// Largest difference of equal ratios of two columns [1]: rounding by half a step in each of two
/// values of at least 20 steps (`least_resolved`).
constexpr double ratio_tolerance = 0.05;

/// Cups of powder shear cells that are sold, with their radii [m].
struct Cup {
    double inner_radius, outer_radius;
};
constexpr std::array<Cup, 2> common_cups = {{{0.0105, 0.0215}, {0.0105, 0.016}}};

/// Row of an interval, by the indices of both.
struct RowOfFile {
    std::size_t interval, row;
    double ratio;
};

/// Smallest magnitude of a column's values [SI unit] that is resolved well enough for a ratio: 20
/// of the smallest differences between values, but no more than a fifth of the largest value, since
/// few distinct values lie far apart.
double least_resolved(const std::vector<IntervalSeries>& series, std::string_view name) {
    std::vector<double> known;
    double largest = 0;
    for (const IntervalSeries& each : series)
        for (const double value : each.column(name)) {
            if (!std::isfinite(value)) continue;
            known.push_back(value);
            largest = std::max(largest, std::abs(value));
        }
    return known.empty() ? 0 : std::min(20 * least_step(std::move(known)), 0.2 * largest);
}

/// Ratios of two columns in all rows in which both are known to 5 %.
std::vector<RowOfFile> ratios(const std::vector<IntervalSeries>& series, std::string_view above,
                              std::string_view below) {
    const double least_above = least_resolved(series, above);
    const double least_below = least_resolved(series, below);
    std::vector<RowOfFile> result;
    for (std::size_t k = 0; k < series.size(); ++k) {
        const auto &a = series[k].column(above), &b = series[k].column(below);
        if (a.empty() || b.empty()) continue;
        for (std::size_t i = 0; i < a.size(); ++i)
            if (std::abs(a[i]) > least_above && std::abs(b[i]) > least_below)
                result.push_back({k, i, a[i] / b[i]});
    }
    return result;
}

bool close(double a, double b) {
    return std::abs(a / b - 1) < ratio_tolerance;
}

/// Most frequent ratio: the one with most others within 5 %.
double most_frequent(const std::vector<RowOfFile>& rows) {
    std::vector<double> sorted;
    for (const RowOfFile& row : rows)
        sorted.push_back(row.ratio);
    std::ranges::sort(sorted);
    double best = 0;
    std::size_t most = 0, end = 0;
    for (std::size_t begin = 0; begin < sorted.size(); ++begin) {
        while (end < sorted.size() &&
               sorted[end] <= sorted[begin] + ratio_tolerance * std::abs(sorted[begin]))
            ++end;
        if (end - begin > most) {
            most = end - begin;
            best = sorted[begin + (end - begin) / 2];
        }
    }
    return best;
}

std::vector<Remark> only_if(bool found, Remark fault) {
    return found ? std::vector<Remark>{std::move(fault)} : std::vector<Remark>();
}

std::size_t rows_in(const std::vector<Lines>& lines) {
    std::size_t count = 0;
    for (const auto& [first, last, file] : lines)
        count += static_cast<std::size_t>(last - first + 1);
    return count;
}

/// Finds rows in which a ratio of two columns differs from the constant of the cell.
std::vector<Remark> check_ratio(const std::vector<IntervalSeries>& series, const char* stress,
                                const char* force, double constant) {
    const std::vector<RowOfFile> rows = ratios(series, stress, force);
    if (constant == 0) return {};
    Remark fault{.kind = Kind::ratio_of_columns, .quantity = force, .of = rows.size()};
    std::vector<double> factors;
    for (const RowOfFile& row : rows) {
        if (close(row.ratio, constant)) continue;
        add_line(fault.lines, series[row.interval].line[row.row]);
        factors.push_back(constant / row.ratio);
    }
    if (factors.empty()) return {};
    fault.count = factors.size();
    fault.size = median(factors);
    return {fault};
}

/// Finds a column that is proportional to a quantity it should not be proportional to, while the
/// column that should be is not: both columns are in each other's place.
std::vector<Remark> check_swapped(const std::vector<IntervalSeries>& series) {
    const auto constant = [&](std::string_view above, std::string_view below) {
        const std::vector<RowOfFile> rows = ratios(series, above, below);
        const double usual = most_frequent(rows);
        const auto agree = std::ranges::count_if(
            rows, [&](const RowOfFile& row) { return close(row.ratio, usual); });
        // Chosen: so many rows do not agree by chance; a tenth may be noise at small values.
        return rows.size() >= 20 && agree > 0.9 * static_cast<double>(rows.size());
    };
    const std::array<std::array<const char*, 3>, 2> triples = {
        {{"torque", "shear_stress", "angular_velocity"},
         {"normal_force", "normal_stress", "height"}}};
    std::vector<Remark> faults;
    for (const auto& [measured, derived, other] : triples) {
        const bool wrong =
            !ratios(series, derived, measured).empty() && !constant(derived, measured);
        if (wrong && constant(other, measured))
            faults.push_back({.kind = Kind::swapped_columns, .names = {other, measured, derived}});
    }
    return faults;
}

/// Points that a file left out, by line, for sums over ranges of lines.
class SkippedPoints {
  public:
    explicit SkippedPoints(const BlockFile& file) {
        for (const Remark& rows : file.skipped)
            if (rows.kind != Kind::after_interval && rows.kind != Kind::without_point_number)
                ranges_.emplace_back(rows.first_line(), rows_in(rows.lines));
        std::ranges::sort(ranges_);
        for (const auto& range : ranges_)
            sums_.push_back(sums_.back() + range.second);
    }

    /// Number of points in the ranges that begin after line `after` and up to line `last`.
    std::size_t between(int after, int last) const { return sum_to(last) - sum_to(after); }

  private:
    std::size_t sum_to(int line) const {
        const auto end =
            std::ranges::upper_bound(ranges_, line, {}, &std::pair<int, std::size_t>::first);
        return sums_[static_cast<std::size_t>(end - ranges_.begin())];
    }

    std::vector<std::pair<int, std::size_t>> ranges_;  ///< first line and number of points
    std::vector<std::size_t> sums_ = {0};              ///< points of the ranges before each
};

std::vector<Remark> check_declared(const BlockFile& file) {
    std::vector<Remark> faults;
    const SkippedPoints skipped(file);
    int end = 0;  // last line of the interval before
    for (std::size_t i = 0; i < file.blocks.size(); ++i) {
        const Block& block = file.blocks[i];
        std::size_t rows = block.table.rows.size();
        if (block.table.rows.empty()) continue;
        const int first = std::max(block.table.header.line, end);
        const int last = end = block.table.rows.back().line;
        if (!block.declared_rows) continue;
        // Points without values may also follow the last row.
        const int next = i + 1 < file.blocks.size() ? file.blocks[i + 1].table.header.line
                                                    : std::numeric_limits<int>::max();
        rows += skipped.between(first, std::max(last, next));
        if (rows == *block.declared_rows) continue;
        faults.push_back({.kind = Kind::declared_rows,
                          .lines = {{block.table.rows.front().line, last}},
                          .count = rows,
                          .of = *block.declared_rows,
                          .names = {fmt::format("{}{}", block.number,
                                                block.test.empty() ? "" : " of " + block.test)}});
    }
    return faults;
}

std::vector<Remark> check_times(const std::vector<IntervalSeries>& series) {
    Remark fault{.kind = Kind::time_goes_back};
    for (const IntervalSeries& each : series)
        for (std::size_t i = 1; i < each.time.size(); ++i)
            if (each.time[i] < each.time[i - 1]) add_line(fault.lines, each.line[i]);
    return only_if(!fault.lines.empty(), fault);
}

/// Finds normal forces or stresses that are negative in every interval with values: recordings of
/// tension, from which no reading of grains is made.
std::vector<Remark> check_compression(const std::vector<IntervalSeries>& series) {
    Remark fault{.kind = Kind::no_compression};
    for (const IntervalSeries& each : series) {
        const std::vector<double>& normal = each.normal();
        for (std::size_t i = 0; i < normal.size(); ++i) {
            fault.of += std::isfinite(normal[i]);
            if (normal[i] < 0) add_line(fault.lines, each.line[i]);
        }
    }
    // Noise about zero is negative in half of the rows; a few positive rows, as before the lid
    // touches the beads, leave the sign in no doubt.
    constexpr double most_positive = 0.1;
    fault.count = rows_in(fault.lines);
    return only_if(
        static_cast<double>(fault.count) > (1 - most_positive) * static_cast<double>(fault.of),
        fault);
}

std::vector<Remark> check_repeated(const BlockFile& file) {
    Remark fault{.kind = Kind::repeated_rows};
    for (const Block& block : file.blocks) {
        const auto& rows = block.table.rows;
        for (std::size_t i = 1; i < rows.size(); ++i) {
            const bool same =
                std::ranges::equal(rows[i].cells, rows[i - 1].cells,
                                   [](const Cell& a, const Cell& b) { return a.text == b.text; });
            if (same) add_line(fault.lines, rows[i].line);
        }
    }
    fault.count = rows_in(fault.lines);
    return only_if(fault.count > 0, fault);
}

/// Names of the tests of a file, each once.
std::vector<std::string> tests_of(const BlockFile& file) {
    std::vector<std::string> tests;
    for (const Block& block : file.blocks)
        if (std::ranges::find(tests, block.test) == tests.end()) tests.push_back(block.test);
    return tests;
}

std::vector<Remark> check_tests(std::vector<std::string> tests) {
    constexpr std::size_t told = 3;  // names in the message, beside their number
    const std::size_t count = tests.size();
    tests.resize(std::min(count, told));
    return only_if(count > 1, {.kind = Kind::several_tests, .count = count, .names = tests});
}

}  // namespace

CellFromColumns cell_from_columns(const std::vector<IntervalSeries>& series) {
    CellFromColumns cell;
    cell.stress_per_force = most_frequent(ratios(series, "normal_stress", "normal_force"));
    const std::vector<RowOfFile> rows = ratios(series, "shear_stress", "torque");
    cell.stress_per_torque = most_frequent(rows);
    for (const Cup& cup : common_cups) {
        const AnnularCell annulus{.inner_radius = cup.inner_radius,
                                  .outer_radius = cup.outer_radius};
        // The areas of the cups differ by a factor of 2.4, far more than the 1 % allowed here.
        const double expected = shear_stress(1, annulus);
        const bool force_fits =
            cell.stress_per_force != 0 &&
            std::abs(cell.stress_per_force / normal_stress(1, annulus) - 1) < 0.01;
        const bool torque_fits = std::abs(std::abs(cell.stress_per_torque) / expected - 1) < 0.01;
        const bool unknown_force = cell.stress_per_force == 0;
        if (!force_fits && !(unknown_force && torque_fits)) continue;
        const auto fitting = std::ranges::find_if(
            rows, [&](const RowOfFile& row) { return close(row.ratio, expected); });
        if (!rows.empty() && fitting == rows.end()) continue;
        cell.inner_radius = cup.inner_radius;
        cell.outer_radius = cup.outer_radius;
        if (!rows.empty()) cell.stress_per_torque = expected;
    }
    return cell;
}

namespace {

/// A fault for each column of which some rows of an interval have no value.
std::vector<Remark> check_missing(const std::vector<IntervalSeries>& series) {
    std::vector<Remark> faults;
    for (const auto& [name, values] : series_columns()) {
        if (name == "shear_rate") continue;  // computed by instruments, and read by no study
        Remark fault{.kind = Kind::missing_values, .quantity = std::string(name), .count = 0};
        for (const IntervalSeries& each : series) {
            const auto& column = each.*values;
            const auto is_known = [](double value) { return std::isfinite(value); };
            const auto known = static_cast<std::size_t>(std::ranges::count_if(column, is_known));
            if (known == 0) continue;
            fault.of += column.size();
            fault.count += column.size() - known;
            for (std::size_t i = 0; i < column.size(); ++i)
                if (!is_known(column[i])) add_line(fault.lines, each.line[i]);
        }
        if (fault.count > 0) faults.push_back(std::move(fault));
    }
    return faults;
}

}  // namespace

std::vector<Remark> hidden_rows(const BlockFile& file) {
    if (file.hidden.empty()) return {};
    return {{.kind = Kind::hidden_rows, .files = {file.file}, .lines = file.hidden}};
}

namespace {

/// Intervals of one test.
std::vector<IntervalSeries> series_of_test(const BlockFile& file,
                                           const std::vector<IntervalSeries>& series,
                                           const std::string& test) {
    std::vector<IntervalSeries> result;
    for (std::size_t i = 0; i < series.size(); ++i)
        if (file.blocks[i].test == test) result.push_back(series[i]);
    return result;
}

/// Checks of one test whose cell has constants of its own.
std::vector<Remark> check_ratios(const std::vector<IntervalSeries>& series,
                                 const CellFromColumns& cell) {
    std::vector<Remark> faults =
        check_ratio(series, "shear_stress", "torque", cell.stress_per_torque);
    append(faults, check_ratio(series, "normal_stress", "normal_force", cell.stress_per_force));
    append(faults, check_swapped(series));
    return faults;
}

}  // namespace

std::vector<Remark> check_file(const BlockFile& file, const std::vector<IntervalSeries>& series,
                               const CellFromColumns& cell) {
    std::vector<Remark> faults;
    const std::vector<std::string> tests = tests_of(file);
    if (tests.size() == 1) append(faults, check_ratios(series, cell));
    for (const std::string& test : tests) {
        if (tests.size() == 1) break;
        // Each test of a file may have been made with another cell.
        const std::vector<IntervalSeries> part = series_of_test(file, series, test);
        append(faults, check_ratios(part, cell_from_columns(part)));
    }
    append(faults, check_declared(file));
    append(faults, check_times(series));
    append(faults, check_compression(series));
    append(faults, check_repeated(file));
    append(faults, check_tests(tests));
    if (tests.size() == 1)
        append(faults, header_against_columns(file, cell.stress_per_torque, cell.stress_per_force));
    append(faults, missed_set_points(file));
    append(faults, hidden_rows(file));
    append(faults, check_missing(series));
    for (Remark& fault : faults)
        fault.files = {file.file};
    return faults;
}

}  // namespace pendular
