#include "data/recording.h"

#include <fmt/format.h>

#include <cmath>

#include "data/columns.h"

namespace pendular {
namespace {

const std::vector<std::string_view> recording_columns = {
    "time", "torque", "normal_force", "height", "angular_velocity", "interval"};

/// Time may start again with a new interval, never within one.
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

}  // namespace

Recording read_recording(const std::filesystem::path& path) {
    const Table table = read_table(path);
    const Columns columns(table);
    for (const std::string_view name : recording_columns)
        if (name != "interval") columns.require(name);

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
    check_time(recording, table, columns);
    return recording;
}

}  // namespace pendular
