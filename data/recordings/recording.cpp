#include "data/recordings/recording.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "data/files/columns.h"

namespace pendular {
namespace {

const std::vector<std::string_view> recording_columns = {
    "time",     "torque",       "normal_force",  "height",    "angular_velocity",
    "interval", "shear_stress", "normal_stress", "shear_rate"};

const std::vector<std::string_view> needed_columns = {"time", "torque", "normal_force", "height",
                                                      "angular_velocity"};

/// Checks that time does not go back, except where a new interval begins.
/// @throws InputError at the first time that goes back within an interval
void check_time(const Recording& recording, const Table& table, const Columns& columns) {
    for (std::size_t i = 1; i < recording.size(); ++i) {
        if (recording.time[i] >= recording.time[i - 1]) continue;
        const bool has_intervals = !recording.interval.empty();
        if (has_intervals && recording.interval[i] != recording.interval[i - 1]) continue;
        throw InputError(
            columns.at(table.rows[i], "time"),
            fmt::format("time goes back from {:.6g} to {:.6g} s; {}", recording.time[i - 1],
                        recording.time[i],
                        has_intervals ? "it may do so only where the interval changes"
                                      : "add a column 'Interval [1]' that changes here, or "
                                        "split the file"));
    }
}

void check_row(const Row& row, const Columns& columns) {
    if (columns.value(row, "height") <= 0)
        throw InputError(columns.at(row, "height"), "a gap must be positive; check its zero");
    const auto interval = columns.value_if_any(row, "interval");
    if (interval && *interval != std::floor(*interval))
        throw InputError(columns.at(row, "interval"), "an interval must be a whole number");
}

/// Values in SI units of an optional column that repeats a measured quantity; empty if the file has
/// no readable column of this name, NaN where a cell is not a number.
std::vector<double> repeated_column(const Table& table, const Columns& columns,
                                    std::string_view name) {
    std::vector<double> values;
    const auto read = [&](auto&& what, auto otherwise) {
        try {
            return what();
        } catch (const InputError&) {
            return otherwise;
        }
    };
    if (!read([&] { return columns.has(name); }, false)) return values;
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    for (const Row& row : table.rows)
        values.push_back(
            read([&] { return columns.value_if_any(row, name).value_or(none); }, none));
    return values;
}

}  // namespace

Recording read_recording(const std::filesystem::path& path) {
    const Table table = read_table(path);
    const Columns columns(table);
    for (const std::string_view name : needed_columns)
        columns.require(name);

    Recording recording;
    recording.file = table.file;
    recording.unused_columns = columns.others(recording_columns);
    for (const Row& row : table.rows) {
        check_row(row, columns);
        recording.line.push_back(row.line);
        recording.time.push_back(columns.value(row, "time"));
        recording.torque.push_back(columns.value(row, "torque"));
        recording.normal_force.push_back(columns.value(row, "normal_force"));
        recording.height.push_back(columns.value(row, "height"));
        recording.angular_velocity.push_back(columns.value(row, "angular_velocity"));
        if (columns.has("interval")) recording.interval.push_back(columns.value(row, "interval"));
    }
    recording.shear_stress = repeated_column(table, columns, "shear_stress");
    recording.normal_stress = repeated_column(table, columns, "normal_stress");
    recording.shear_rate = repeated_column(table, columns, "shear_rate");
    check_time(recording, table, columns);
    return recording;
}

void erase_rows(Recording& recording, const std::vector<bool>& marked) {
    const auto erase = [&](auto& column) {
        if (column.empty()) return;  // the file has no such column
        std::size_t kept = 0;
        for (std::size_t i = 0; i < marked.size(); ++i)
            if (!marked[i]) column[kept++] = column[i];
        column.resize(kept);
    };
    erase(recording.line);
    for (auto* column : {&recording.time, &recording.torque, &recording.normal_force,
                         &recording.height, &recording.angular_velocity, &recording.interval,
                         &recording.shear_stress, &recording.normal_stress, &recording.shear_rate})
        erase(*column);
}

}  // namespace pendular
