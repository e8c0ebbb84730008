#include "data/recordings/recording_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "data/quantities/number.h"

namespace pendular {
namespace {

/// Result of a function; another value where it throws an InputError, as for a column that the
/// instrument computes, which nothing depends on.
template <typename Function, typename Value>
Value or_else(Function function, Value otherwise) {
    try {
        return function();
    } catch (const InputError&) {
        return otherwise;
    }
}

/// Columns in which a recording needs a value in every row: torque, normal force and angular
/// velocity, or the stresses, the force on a lever and the speed at the mean radius that stand in
/// for them.
/// @throws InputError at the header if a column is missing
std::vector<std::string_view> needed_columns(const Columns& columns) {
    const std::vector<std::vector<std::string_view>> all = {
        {"time"},
        {"torque", "shear_stress", "lever_force"},
        {"normal_force", "normal_stress"},
        {"height"},
        {"angular_velocity", "shear_velocity"}};
    std::vector<std::string_view> names;
    for (const auto& alike : all) {
        const auto has = [&](std::string_view name) { return columns.has(name); };
        const auto found = std::ranges::find_if(alike, has);
        names.push_back(found == alike.end() ? alike.front() : *found);
        columns.require(names.back());
    }
    return names;
}

}  // namespace

RecordingRows::RecordingRows(const Columns& columns, std::size_t most)
    : columns_(columns), most_(most) {
    std::vector<std::string_view> always = needed_columns(columns);
    always.push_back("interval");
    for (const SeriesColumn& series : series_columns()) {
        const bool needed = std::ranges::find(always, series.name) != always.end();
        const auto find = [&] { return columns.conversion(series.name); };
        const auto from = needed ? find() : or_else(find, std::optional<Columns::Conversion>());
        if (!from) continue;
        if (series.name == "time") time_ = read_.size();
        if (series.name == "height") height_ = read_.size();
        if (series.name == "interval") interval_ = read_.size();
        read_.push_back({series, *from, needed});
    }
    values_.resize(read_.size());
    sums_.resize(read_.size());
}

double RecordingRows::value(const Row& row, const ReadColumn& column) const {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    if (column.may_lack) return columns_.value_if_any(row, column.series.name).value_or(none);
    if (column.needed) return columns_.value(row, column.series.name);
    return or_else([&] { return columns_.value_if_any(row, column.series.name).value_or(none); },
                   none);
}

std::vector<std::string_view> RecordingRows::needed() const {
    std::vector<std::string_view> names;
    for (const ReadColumn& column : read_)
        if (column.needed) names.push_back(column.series.name);
    return names;
}

void RecordingRows::allow_missing(std::string_view quantity) {
    for (ReadColumn& column : read_)
        column.may_lack = column.may_lack || column.series.name == quantity;
}

bool RecordingRows::may_lack(std::string_view quantity) const {
    return std::ranges::any_of(read_, [&](const ReadColumn& column) {
        return column.may_lack && column.series.name == quantity;
    });
}

bool RecordingRows::needs(std::size_t column) const {
    return std::ranges::any_of(
        read_, [&](const ReadColumn& each) { return each.needed && each.from.index == column; });
}

std::string_view RecordingRows::missing(const Row& row) const {
    for (const ReadColumn& column : read_)
        if (column.needed && !column.may_lack && !columns_.value_if_any(row, column.series.name))
            return column.series.name;
    return {};
}

void RecordingRows::add(const Row& row) {
    std::ranges::transform(read_, values_.begin(),
                           [&](const ReadColumn& column) { return value(row, column); });
    if (const auto wrong = add_values(row.line))
        throw InputError(columns_.at(row, wrong->quantity), wrong->text);
}

bool RecordingRows::add(int line, const std::vector<double>& numbers) {
    for (std::size_t k = 0; k < read_.size(); ++k) {
        const auto& [index, factor, offset] = read_[k].from;
        values_[k] = factor * numbers[index] + offset;
        if (!(std::abs(values_[k]) <= largest_magnitude)) return false;
    }
    return !add_values(line);
}

/// Fault of the row in `values_`, which is not added yet.
std::optional<RecordingRows::Fault> RecordingRows::fault() const {
    if (values_[height_] <= 0)
        return Fault{"height",
                     "a gap must be positive; check its zero, or, if the number marks a missing "
                     "value, state it in [[recording]] as in missing = [\"-999\"]"};
    const double interval = interval_ ? values_[*interval_] : 0;
    if (interval != std::floor(interval))
        return Fault{"interval", "an interval must be a whole number"};
    if (values_[time_] < time_before_ && interval == interval_before_)
        return Fault{
            "time",
            fmt::format("time goes back from {:.6g} to {:.6g} s; {}", time_before_, values_[time_],
                        interval_ ? "it may do so only where the interval changes"
                                  : "add a column 'Interval [1]' that changes here, or "
                                    "split the file")};
    if (series_.size() >= most_)
        return Fault{"interval", fmt::format("more than {} intervals up to this line; split the "
                                             "file into several files",
                                             most_)};
    return std::nullopt;
}

std::optional<RecordingRows::Fault> RecordingRows::add_values(int line) {
    if (auto wrong = fault()) return wrong;
    time_before_ = values_[time_];
    if (interval_) {
        if (count_ > 0 && values_[*interval_] != interval_before_) append_mean();
        interval_before_ = values_[*interval_];
    }
    if (count_ == 0) {
        first_line_ = line;
        sums_ = values_;
    } else {
        std::ranges::transform(sums_, values_, sums_.begin(), std::plus());
    }
    if (++count_ >= averaged_rows_) append_mean();
    return std::nullopt;
}

IntervalSeries RecordingRows::finish() {
    if (count_ > 0) append_mean();
    return std::move(series_);
}

std::vector<std::string> RecordingRows::unused_columns() const {
    std::vector<std::string_view> names;
    for (const SeriesColumn& series : series_columns())
        names.push_back(series.name);
    return columns_.others(names);
}

void RecordingRows::append_mean() {
    series_.line.push_back(first_line_);
    for (std::size_t k = 0; k < read_.size(); ++k)
        (series_.*read_[k].series.values).push_back(sums_[k] / count_);
    count_ = 0;
    if (series_.size() >= most_) halve();
}

bool RecordingRows::same_interval(std::size_t row) const {
    return !interval_ || series_.interval[row] == series_.interval[row + 1];
}

void RecordingRows::halve() {
    const std::size_t rows = series_.size();
    std::vector<std::size_t> first;  // row of each mean, of this row alone or with the next
    for (std::size_t row = 0; row < rows; ++row) {
        first.push_back(row);
        if (row + 1 < rows && same_interval(row)) ++row;
    }
    if (first.size() == rows) return;
    for (const ReadColumn& each : read_) {
        std::vector<double>& column = series_.*each.series.values;
        for (std::size_t k = 0; k < first.size(); ++k) {
            // A row alone is both the first and the last of its mean.
            const std::size_t next = k + 1 < first.size() ? first[k + 1] : rows;
            column[k] = (column[first[k]] + column[next - 1]) / 2;
        }
        column.resize(first.size());
    }
    for (std::size_t k = 0; k < first.size(); ++k)
        series_.line[k] = series_.line[first[k]];
    series_.line.resize(first.size());
    averaged_rows_ *= 2;
}

}  // namespace pendular
