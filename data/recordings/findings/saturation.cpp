#include "data/recordings/findings/detectors.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <set>

#include "data/quantities/statistics.h"

namespace pendular {
namespace {

using Kind = Remark::Kind;

/// Limit of the p value, below `finding_significance`, since saturated readings are set aside.
constexpr double certain_saturation = 1e-4;
/// Band below the largest value, over it, whose rows count as at the limit: chosen.
constexpr double band_share = 2e-4;
/// Depth of the rows beside the limit, in bands, at which its edge is sharp: chosen.
constexpr double clear_edge = 5;
/// Rows below the band with which its crowding is compared, and rows at the limit. Chosen: of
/// fewer, no share is known, and one or two rows may be a spike.
constexpr std::size_t least_below = 20, least_rows = 3;
/// Limits of several steps at one torque: their agreement, and the growth of force between them
/// [1].
constexpr double equal_torques = 0.005, growing_force = 1.2;

/// Runs of neighbouring rows.
std::vector<Step> runs_of(const std::vector<bool>& marked) {
    std::vector<Step> runs;
    for (std::size_t k = 0; k < marked.size(); ++k) {
        if (!marked[k]) continue;
        if (runs.empty() || runs.back().end != k)
            runs.push_back({k, k + 1});
        else
            runs.back().end = k + 1;
    }
    return runs;
}

/// One column as magnitudes, with its rows at the largest value.
struct TopRows {
    std::vector<double> values;
    double top = 0, resolution = 0, band = 0;
    std::vector<bool> marked;
    std::vector<Step> runs;  ///< runs of marked rows

    explicit TopRows(std::vector<double> column) : values(std::move(column)) {
        for (double& value : values)
            value = std::abs(value);
        top = *std::ranges::max_element(values);
        resolution = least_step(values);
        band = std::max(0.5 * resolution, band_share * top);
        for (const double value : values)
            marked.push_back(value >= top - band);
        runs = runs_of(marked);
    }
};

/// Whether the rows beside the marked runs lie clearly lower, as beside a smooth peak they do not.
bool has_sharp_edges(const TopRows& rows) {
    std::vector<double> edges;
    for (const Step& run : rows.runs) {
        if (run.begin > 0) edges.push_back(rows.top - rows.values[run.begin - 1]);
        if (run.end < rows.values.size()) edges.push_back(rows.top - rows.values[run.end]);
    }
    return median(edges) > clear_edge * rows.band;
}

/// Probability that as many separate runs reach the largest value, from the number of rows in an
/// equally sparse range below it [1].
double crowding_p(const TopRows& rows) {
    const std::size_t runs = rows.runs.size();
    std::vector<double> below;
    for (std::size_t k = 0; k < rows.values.size(); ++k)
        if (!rows.marked[k]) below.push_back(rows.top - rows.band - rows.values[k]);
    const std::size_t near = std::max(runs, least_below);
    if (below.size() < near) return 1;
    std::ranges::nth_element(below, below.begin() + static_cast<std::ptrdiff_t>(near) - 1);
    const double width = std::max(rows.band, rows.resolution);
    const double share = width / (width + below[near - 1]);
    return binomial_at_least(static_cast<double>(runs), static_cast<double>(runs + near), share);
}

/// Probability that rows stay as long at the largest value, from the share of the other rows that
/// stay at the value of their neighbour [1].
double flatness_p(const TopRows& rows) {
    double staying = 0, others = 0, flat = 0;
    for (std::size_t k = 1; k < rows.values.size(); ++k) {
        if (rows.marked[k] && rows.marked[k - 1]) {
            ++flat;
        } else if (!rows.marked[k] && !rows.marked[k - 1]) {
            ++others;
            staying += std::abs(rows.values[k] - rows.values[k - 1]) <= rows.band;
        }
    }
    if (others < static_cast<double>(least_below)) return 1;
    return std::pow((staying + 1) / (others + 2), flat);
}

/// Whether the rows at the largest value are a few single ones, far above all others: spikes that
/// are equal, as an overflow of the converter is, and say nothing of the other rows.
bool are_equal_spikes(const TopRows& rows) {
    constexpr std::size_t most = 5;  // chosen: more would be a limit that is met again and again
    constexpr double far = 2;        // chosen: a torque that is cut off has rows just below
    if (rows.runs.size() > most ||
        std::ranges::any_of(rows.runs, [](const Step& run) { return run.end - run.begin > 1; }))
        return false;
    double next = 0;
    for (std::size_t k = 0; k < rows.values.size(); ++k)
        if (!rows.marked[k]) next = std::max(next, rows.values[k]);
    return rows.top > far * next;
}

/// Whether few rows are at the largest value, told without their resolution, which takes a sort:
/// within half of that, a row is only at the largest value itself.
bool has_few_at_top(const std::vector<double>& column) {
    double top = 0;
    for (const double value : column)
        top = std::max(top, std::abs(value));
    const auto at_top = [&](double value) { return std::abs(value) >= top - band_share * top; };
    return std::ranges::count_if(column, at_top) < static_cast<std::ptrdiff_t>(least_rows);
}

Remark saturation_of(const std::string& file, const std::string& quantity, double limit, double p,
                     const std::set<int>& lines) {
    Remark found{
        .kind = Kind::saturation, .quantity = quantity, .files = {file}, .size = limit, .p = p};
    for (const int line : lines)
        add_line(found.lines, line);
    return found;
}

/// Saturation of the rows of a column at its largest value, if it is certain.
std::optional<Remark> at_largest(const std::string& file, const std::vector<int>& lines_of_rows,
                                 const std::string& quantity, const std::vector<double>& column) {
    if (has_few_at_top(column)) return std::nullopt;
    const TopRows rows(column);
    const auto count = std::ranges::count(rows.marked, true);
    if (rows.top == 0 || count < static_cast<std::ptrdiff_t>(least_rows) || !has_sharp_edges(rows))
        return std::nullopt;
    if (are_equal_spikes(rows)) return std::nullopt;
    // A force controller may hold its set point exactly, so that a constant force means nothing.
    const double p = quantity != "normal_force" ? 2 * std::min(crowding_p(rows), flatness_p(rows))
                                                : crowding_p(rows);
    if (p >= certain_saturation) return std::nullopt;
    std::set<int> lines;
    for (std::size_t k = 0; k < rows.marked.size(); ++k)
        if (rows.marked[k]) lines.insert(lines_of_rows[k]);
    return saturation_of(file, quantity, rows.top, p, lines);
}

/// Step with the medians of its columns, as magnitudes.
struct StepLevels {
    const RecordedStep* step;
    double force, torque;
};

/// Saturation of whole steps: torques of the steps with the largest forces that do not grow.
std::optional<Remark> in_several_steps(const Recording& recording,
                                       const std::vector<RecordedStep>& steps) {
    std::vector<StepLevels> levels;
    for (const RecordedStep& step : steps)
        if (const auto part = level_part(step))
            levels.push_back({&step, median(part->normal_force), median(part->torque)});
    std::ranges::sort(levels, std::greater{}, &StepLevels::force);
    std::size_t count = levels.empty() ? 0 : 1;
    while (count < levels.size() &&
           std::abs(levels[count].torque / levels[0].torque - 1) < equal_torques &&
           levels[count - 1].force > growing_force * levels[count].force)
        ++count;
    if (count < 3) return std::nullopt;
    // Chance that all agree if each differed from the first at random, by up to the growth of the
    // force.
    const double p =
        std::pow(equal_torques / std::log(growing_force), static_cast<double>(count - 1));
    std::set<int> lines;
    for (std::size_t k = 0; k < count; ++k)
        lines.insert(levels[k].step->series.line.begin(), levels[k].step->series.line.end());
    return saturation_of(recording.file, "torque", levels[0].torque, p, lines);
}

}  // namespace

std::vector<Remark> saturations(const Recording& recording,
                                const std::vector<RecordedStep>& steps) {
    std::vector<Remark> found;
    auto torque = at_largest(recording.file, recording.line, "torque", recording.torque);
    if (!torque) torque = in_several_steps(recording, steps);
    if (torque) found.push_back(*std::move(torque));
    if (auto force =
            at_largest(recording.file, recording.line, "normal_force", recording.normal_force))
        found.push_back(*std::move(force));
    return found;
}

std::optional<Remark> saturated_shear(const std::string& file, const IntervalSeries& series) {
    const std::vector<double>& shear = series.shear();
    if (series.time.empty() || shear.size() < shortest_step ||
        !std::ranges::all_of(shear, [](double value) { return std::isfinite(value); }))
        return std::nullopt;
    const char* const quantity = !series.shear_stress.empty() ? "shear_stress"
                                 : series.torque.empty()      ? "lever_force"
                                                              : "torque";
    auto found = at_largest(file, series.line, quantity, shear);
    if (!found) return std::nullopt;
    found->relative =
        static_cast<double>(all_lines(found->lines).size()) / static_cast<double>(shear.size());
    found->corrected = true;  // what a study does
    return found;
}

std::vector<Remark> saturated_steps(const std::vector<Remark>& saturations,
                                    const Recording& recording,
                                    const std::vector<RecordedStep>& steps) {
    std::vector<Remark> found;
    for (const Remark& each : saturations) {
        const std::set<int> lines = all_lines(each.lines);
        Remark in_step = each;
        in_step.lines.clear();
        for (const RecordedStep& step : steps) {
            const std::size_t rows = lines_within(lines, recording.line[step.rows.begin],
                                                  recording.line[step.rows.end - 1]);
            if (rows < least_rows) continue;
            Remark& one = found.emplace_back(in_step);
            one.step = step.number;
            one.relative =
                static_cast<double>(rows) / static_cast<double>(step.rows.end - step.rows.begin);
        }
    }
    return found;
}

std::vector<Remark> separate_from_spikes(const std::vector<Remark>& saturations,
                                         const std::string& file,
                                         std::vector<RecordedStep>& steps) {
    std::vector<Remark> found;
    std::vector<std::set<int>> lines;
    for (const Remark& each : saturations)
        lines.push_back(all_lines(each.lines));
    for (RecordedStep& step : steps) {
        std::erase_if(step.spikes, [&](std::size_t k) {
            const int line = step.series.line[k];
            const auto cause = std::ranges::find_if(
                lines, [&](const std::set<int>& each) { return each.contains(line); });
            if (cause == lines.end()) return false;
            const Remark& saturation = saturations[static_cast<std::size_t>(cause - lines.begin())];
            found.push_back({.kind = Kind::saturated_row,
                             .quantity = saturation.quantity,
                             .files = {file},
                             .lines = {{line, line}},
                             .limit = saturation.size});
            return true;
        });
    }
    return found;
}

std::vector<Remark> saturated_columns(const std::vector<Remark>& found) {
    std::vector<Remark> columns;
    for (const char* const quantity : {"torque", "normal_force"}) {
        Remark column{.kind = Kind::saturated_column, .quantity = quantity};
        for (const Remark& each : found) {
            if (each.kind != Kind::saturation || each.quantity != quantity) continue;
            column.add({each.file(), 0, 0});
            column.because.push_back(each);
        }
        if (!column.because.empty()) columns.push_back(std::move(column));
    }
    return columns;
}

}  // namespace pendular
