#include "data/recordings/recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "data/files/columns.h"
#include "data/files/formats/layouts.h"

namespace pendular {
namespace {

const std::vector<std::string_view> needed_columns = {"time", "torque", "normal_force", "height",
                                                      "angular_velocity"};

/// Whether the instrument computes a column from others.
bool repeats_others(std::string_view name) {
    return name == "shear_stress" || name == "normal_stress" || name == "shear_rate";
}

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

/// Checks that a table has all columns that a recording needs; stresses may stand in for torque and
/// normal force.
/// @throws InputError at the header if a column is missing
void require_columns(const Columns& columns) {
    for (const std::string_view name : needed_columns) {
        if (columns.has(name)) continue;
        if (name == "torque" && columns.has("shear_stress")) continue;
        if (name == "normal_force" && columns.has("normal_stress")) continue;
        columns.require(name);
    }
}

/// Columns whose values a recording needs in every row: torque and normal force, or the stresses
/// that stand in for them.
std::vector<std::string_view> columns_to_fill(const Columns& columns) {
    std::vector<std::string_view> names = needed_columns;
    const auto stand_in = [&](std::string_view name, std::string_view stress) {
        if (!columns.has(name)) std::ranges::replace(names, name, stress);
    };
    stand_in("torque", "shear_stress");
    stand_in("normal_force", "normal_stress");
    return names;
}

/// Reads the recording from a table that has all columns, every row of which must be valid.
Recording recording_of_table(const Table& table) {
    const Columns columns(table);
    require_columns(columns);
    const std::vector<std::string_view> filled = columns_to_fill(columns);
    Recording recording;
    recording.file = table.file;
    std::vector<std::string_view> names;
    std::vector<SeriesColumn> present;
    for (const SeriesColumn& column : series_columns()) {
        names.push_back(column.name);
        if (!repeats_others(column.name) && columns.has(column.name)) present.push_back(column);
    }
    recording.unused_columns = columns.others(names);
    for (const Row& row : table.rows) {
        check_row(row, columns);
        for (const std::string_view name : filled)
            columns.value(row, name);  // refuses a cell without a number
        recording.line.push_back(row.line);
        for (const auto& [name, values] : present)
            (recording.*values).push_back(columns.value(row, name));
    }
    for (const auto& [name, values] : series_columns())
        if (repeats_others(name)) recording.*values = repeated_column(table, columns, name);
    check_time(recording, table, columns);
    return recording;
}

/// Text that names an interval in messages.
std::string name_of(const Block& block) {
    std::string name = block.number > 0 ? fmt::format("interval {}", block.number) : "a table";
    if (!block.name.empty()) name += fmt::format(" ({})", block.name);
    if (!block.test.empty()) name += fmt::format(" of {}", block.test);
    return name;
}

/// Lines from one row to another.
std::vector<Lines> lines_of(const Row& first, const Row& last) {
    return {{first.line, last.line}};
}

/// Removes rows without a value in a needed column, and lists them.
Table with_all_values(const Block& block, std::vector<Remark>& left_out) {
    const Columns columns(block.table);
    const std::vector<std::string_view> needed = columns_to_fill(columns);
    Table table = block.table;
    table.rows.clear();
    for (const Row& row : block.table.rows) {
        const auto missing = std::ranges::find_if(
            needed, [&](std::string_view name) { return !columns.value_if_any(row, name); });
        if (missing == needed.end()) {
            table.rows.push_back(row);
            continue;
        }
        leave_out(left_out, {.kind = Remark::Kind::no_value,
                             .quantity = std::string(*missing),
                             .files = {table.file},
                             .lines = lines_of(row, row),
                             .names = {name_of(block)}});
    }
    return table;
}

/// Appends the rows of an interval, whose number becomes `number`. Columns that only one of the two
/// has are dropped.
void append_interval(Recording& whole, const Recording& part, double number) {
    for (const auto& [name, values] : series_columns()) {
        if (name == "interval") continue;
        auto& to = whole.*values;
        const auto& from = part.*values;
        if (whole.size() > 0 && (to.size() != whole.size() || from.empty()))
            to.clear();
        else
            to.insert(to.end(), from.begin(), from.end());
    }
    whole.line.insert(whole.line.end(), part.line.begin(), part.line.end());
    whole.interval.resize(whole.size(), number);
}

/// Whether the intervals' own numbers tell them apart: they increase within a single test.
bool numbers_tell_apart(const std::vector<Block>& blocks) {
    for (std::size_t i = 0; i < blocks.size(); ++i)
        if (blocks[i].number == 0 || (i > 0 && (blocks[i].number <= blocks[i - 1].number ||
                                                blocks[i].test != blocks[i - 1].test)))
            return false;
    return true;
}

/// Leaves rows of an interval out if the user stated another role than steady shear for it.
bool has_other_role(const Block& block, const FileFormat& format, const std::string& file,
                    std::vector<Lines> lines, std::vector<Remark>& left_out) {
    const std::string role = stated_role(block, format);
    if (role.empty() || role == "steady") return false;
    leave_out(left_out, {.kind = Remark::Kind::stated_role,
                         .files = {file},
                         .lines = std::move(lines),
                         .names = {name_of(block), role}});
    return true;
}

/// Recording of a plain table without the intervals to which the user gave another role.
Recording steady_part(Recording recording, const FileFormat& format) {
    if (recording.interval.empty() || format.roles.empty()) return recording;
    std::vector<bool> marked;
    for (std::size_t i = 0; i < recording.size(); ++i) {
        Block interval;
        interval.number = static_cast<int>(std::clamp(recording.interval[i], -1e9, 1e9));
        marked.push_back(has_other_role(interval, format, recording.file,
                                        {{recording.line[i], recording.line[i]}},
                                        recording.left_out));
    }
    recording.erase_rows(marked);
    return recording;
}

}  // namespace

Recording recording_of(const BlockFile& file, const FileFormat& format) {
    if (file.layout == "plain")
        return steady_part(recording_of_table(file.blocks.front().table), format);
    Recording whole;
    whole.file = file.file;
    const bool own_numbers = numbers_tell_apart(file.blocks);
    std::string first_error;
    int count = 0;
    for (const Block& block : file.blocks) {
        ++count;
        if (block.table.rows.empty()) continue;
        const auto lines = lines_of(block.table.rows.front(), block.table.rows.back());
        if (has_other_role(block, format, file.file, lines, whole.left_out)) continue;
        try {
            require_columns(Columns(block.table));
        } catch (const InputError& error) {
            if (first_error.empty()) first_error = error.what();
            leave_out(whole.left_out, {.kind = Remark::Kind::lacks_column,
                                       .files = {file.file},
                                       .lines = lines,
                                       .names = {name_of(block)}});
            continue;
        }
        const Table table = with_all_values(block, whole.left_out);
        if (table.rows.empty()) continue;
        append_interval(whole, recording_of_table(table), own_numbers ? block.number : count);
    }
    if (whole.size() == 0 && !first_error.empty())
        throw InputError(first_error +
                         "; steady shear needs time, torque or shear stress, normal force or "
                         "normal stress, gap, and the lid's speed in one interval. 'pendular "
                         "import FILE' shows what the file has");
    if (whole.size() > 0 && ((whole.torque.empty() && whole.shear_stress.empty()) ||
                             (whole.normal_force.empty() && whole.normal_stress.empty())))
        throw InputError({file.file},
                         "some intervals have torque or normal force and others only stresses; "
                         "export all intervals with the same columns");
    for (const Remark& rows : file.skipped)
        leave_out(whole.left_out, rows);
    return whole;
}

Recording read_recording(const std::filesystem::path& path, const FileFormat& format) {
    return recording_of(read_blocks(path, format), format);
}

void fill_from_stresses(Recording& recording, const AnnularCell& cell) {
    if (recording.torque.empty())
        for (const double stress : recording.shear_stress)
            recording.torque.push_back(torque(stress, cell));
    if (recording.normal_force.empty())
        for (const double stress : recording.normal_stress)
            recording.normal_force.push_back(normal_force(stress, cell));
}

}  // namespace pendular
