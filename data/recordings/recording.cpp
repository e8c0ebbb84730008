#include "data/recordings/recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "data/files/columns.h"
#include "data/files/formats/layouts.h"
#include "data/quantities/statistics.h"
#include "data/recordings/column_kinds.h"
#include "data/recordings/recording_rows.h"

namespace pendular {
namespace {

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

/// Rows of a table with a value of a quantity.
std::vector<std::size_t> rows_with(const Table& table, const Columns& columns,
                                   std::string_view name) {
    std::vector<std::size_t> rows;
    for (std::size_t i = 0; i < table.rows.size(); ++i)
        if (columns.value_if_any(table.rows[i], name)) rows.push_back(i);
    return rows;
}

/// Usual distance of rows, in rows; empty where their distances are not regular: less than three
/// quarters of them differ from the usual one by at most a quarter of it, or by one row.
std::optional<std::size_t> regular_distance(const std::vector<std::size_t>& rows) {
    std::vector<double> distances;
    for (std::size_t k = 1; k < rows.size(); ++k)
        distances.push_back(static_cast<double>(rows[k] - rows[k - 1]));
    if (distances.empty()) return std::nullopt;
    const double usual = std::floor(median(distances));
    const auto regular =
        static_cast<std::size_t>(std::ranges::count_if(distances, [&](double each) {
            return std::abs(each - usual) <= std::max(1.0, usual / 4);
        }));
    if (4 * regular < 3 * distances.size()) return std::nullopt;
    return static_cast<std::size_t>(usual);
}

/// Whether a table has a column less often than the others: values at regular distances in less
/// than half of the rows, but in at least ten. A speed written only where it changes, say, tells
/// nothing of the rows between, and so does no speed.
bool is_slower(const Table& table, const Columns& columns, std::string_view name) {
    constexpr std::size_t fewest = 10;
    if (name == "time" || name == "interval" || name == "angular_velocity" ||
        name == "shear_velocity")
        return false;
    const std::vector<std::size_t> known = rows_with(table, columns, name);
    return known.size() >= fewest && 2 * known.size() < table.rows.size() &&
           regular_distance(known);
}

/// Lets the slower columns of a table lack values.
/// @param found gains a remark for each, with the number of rows without a value
void allow_slower_columns(const Table& table, const Columns& columns, RecordingRows& rows,
                          std::vector<Remark>& found) {
    for (const std::string_view name : rows.needed()) {
        if (!is_slower(table, columns, name)) continue;
        rows.allow_missing(name);
        const auto known = std::ranges::find_if(found, [&](const Remark& each) {
            return each.kind == Remark::Kind::missing_values && each.quantity == name;
        });
        Remark& remark = known != found.end()
                             ? *known
                             : found.emplace_back(Remark{.kind = Remark::Kind::missing_values,
                                                         .quantity = std::string(name),
                                                         .files = {table.file},
                                                         .count = 0});
        remark.of += table.rows.size();
        remark.count += table.rows.size() - rows_with(table, columns, name).size();
    }
}

/// Whether two rows of a series were measured at the same set points: in one interval, with speeds
/// and normal loads that differ by at most 5 %, as steps do (`split_steps`). Values that a row
/// lacks tell nothing.
bool same_set_points(const IntervalSeries& series, std::size_t a, std::size_t b) {
    constexpr double change = 0.05;
    const auto differs = [&](const std::vector<double>& column) {
        if (column.empty() || !std::isfinite(column[a]) || !std::isfinite(column[b])) return false;
        return std::abs(column[a] - column[b]) >
               change * std::max(std::abs(column[a]), std::abs(column[b]));
    };
    return (series.interval.empty() || series.interval[a] == series.interval[b]) &&
           !differs(series.angular_velocity) && !differs(series.shear_velocity) &&
           !differs(series.normal_force) && !differs(series.normal_stress);
}

/// Fills the missing values of a column between those of one set point by straight lines, so that
/// their mean is that of the rows that have them, and up to half of the usual distance before and
/// after each of them by this value.
void fill_between(const IntervalSeries& series, std::vector<double>& column) {
    std::vector<std::size_t> known;
    for (std::size_t i = 0; i < column.size(); ++i)
        if (std::isfinite(column[i])) known.push_back(i);
    const auto usual = regular_distance(known);
    if (!usual || known.size() == column.size()) return;
    const auto same = [&](std::size_t a, std::size_t b) { return same_set_points(series, a, b); };
    std::vector<double> filled = column;
    for (std::size_t k = 0; k + 1 < known.size(); ++k) {
        const std::size_t from = known[k], to = known[k + 1];
        // A longer pause is no slower rate: its rows stay without a value.
        if (!same(from, to) || to - from > 3 * *usual) continue;
        for (std::size_t i = from + 1; i < to; ++i) {
            const double part = static_cast<double>(i - from) / static_cast<double>(to - from);
            filled[i] = (1 - part) * column[from] + part * column[to];
        }
    }
    for (const std::size_t at : known) {
        for (std::size_t i = at + 1; i < column.size() && 2 * (i - at) <= *usual && same(at, i);
             ++i)
            if (std::isnan(filled[i])) filled[i] = column[at];
        for (std::size_t i = at; i-- > 0 && 2 * (at - i) <= *usual && same(at, i);)
            if (std::isnan(filled[i])) filled[i] = column[at];
    }
    column = std::move(filled);
}

/// Rows that slower columns still lack after `fill_between` are left out.
void fill_slower_columns(IntervalSeries& series, const RecordingRows& rows, const std::string& file,
                         const std::string& interval, std::vector<Remark>& left_out) {
    std::vector<bool> lacking(series.size(), false);
    for (const SeriesColumn& column : series_columns()) {
        if (!rows.may_lack(column.name)) continue;
        std::vector<double>& values = series.*column.values;
        fill_between(series, values);
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (lacking[i] || std::isfinite(values[i])) continue;
            lacking[i] = true;
            leave_out(left_out, {.kind = Remark::Kind::no_value,
                                 .quantity = std::string(column.name),
                                 .files = {file},
                                 .lines = {{series.line[i], series.line[i]}},
                                 .names = {interval}});
        }
    }
    series.erase_rows(lacking);
}

/// Adds the rows of an interval, but lists those without a value in a needed column.
void add_rows(const Block& block, RecordingRows& rows, std::vector<Remark>& left_out) {
    for (const Row& row : block.table.rows) {
        const std::string_view missing = rows.missing(row);
        if (missing.empty())
            rows.add(row);
        else
            leave_out(left_out, {.kind = Remark::Kind::no_value,
                                 .quantity = std::string(missing),
                                 .files = {block.table.file},
                                 .lines = lines_of(row, row),
                                 .names = {name_of(block)}});
    }
}

/// Series of an interval from its rows.
IntervalSeries finished_rows(const Block& block, const Columns& columns, RecordingRows& rows,
                             std::vector<Remark>& left_out) {
    allow_slower_columns(block.table, columns, rows, left_out);
    add_rows(block, rows, left_out);
    IntervalSeries series = rows.finish();
    fill_slower_columns(series, rows, block.table.file, name_of(block), left_out);
    return series;
}

/// Appends the rows of an interval, whose number becomes `number`. Columns that only one of the two
/// has are dropped.
void append_interval(Recording& whole, const IntervalSeries& part, double number) {
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

/// Leaves rows of an interval out if the user stated another role than steady shear for it or, if
/// he stated none, its columns show another kind of test.
bool has_other_role(const Block& block, const FileFormat& format, const std::string& file,
                    std::vector<Lines> lines, std::vector<Remark>& left_out) {
    std::string role = stated_role(block, format);
    if (role.empty()) role = block.stated_role;
    const auto kind = role.empty() ? kind_shown_by_columns(block) : std::nullopt;
    if (role == "steady" || (role.empty() && !kind)) return false;
    leave_out(left_out, {.kind = kind ? Remark::Kind::other_test : Remark::Kind::stated_role,
                         .files = {file},
                         .lines = std::move(lines),
                         .names = {name_of(block), kind ? *kind : role}});
    return true;
}

/// Intervals of a plain table, each with the columns and the header of the table.
std::vector<Block> intervals_of(const Block& whole) {
    const Columns columns(whole.table);
    std::vector<Block> blocks;
    std::optional<double> before;
    for (const Row& row : whole.table.rows) {
        const auto number = columns.value_if_any(row, "interval");
        if (blocks.empty() || number != before) {
            Block& block = blocks.emplace_back();
            block.number = static_cast<int>(std::clamp(number.value_or(0), 0.0, 1e9));
            block.test = whole.test;
            block.stated_role = whole.stated_role;
            block.columns = whole.columns;
            block.table = {whole.table.file, whole.table.header, {}, whole.table.delimiter};
        }
        blocks.back().table.rows.push_back(row);
        before = number;
    }
    return blocks;
}

/// A plain table without the intervals that are another kind of test.
Block without_other_tests(const Block& whole, const FileFormat& format,
                          std::vector<Remark>& left_out) {
    Block rest = whole;
    rest.table.rows.clear();
    for (const Block& block : intervals_of(whole)) {
        const auto& rows = block.table.rows;
        if (!has_other_role(block, format, whole.table.file, lines_of(rows.front(), rows.back()),
                            left_out))
            rest.table.rows.insert(rest.table.rows.end(), rows.begin(), rows.end());
    }
    return rest;
}

/// Recording of a plain table, without the intervals to which the user gave another role.
Recording recording_of_rows(const Block& block, const FileFormat& format,
                            std::vector<Remark> left_out) {
    const Table& table = block.table;
    const Columns columns(table);
    RecordingRows rows(columns);
    IntervalSeries series = finished_rows(block, columns, rows, left_out);
    Recording recording{std::move(series), table.file, 1, rows.unused_columns(),
                        std::move(left_out)};
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

/// Recording of a plain table, without the intervals that are no steady shear.
Recording recording_of_table(const Block& block, const FileFormat& format) {
    std::vector<Remark> left_out;
    if (!kind_shown_by_columns(block)) return recording_of_rows(block, format, {});
    const Block rest = without_other_tests(block, format, left_out);
    if (!rest.table.rows.empty()) return recording_of_rows(rest, format, std::move(left_out));
    Recording nothing;
    nothing.file = block.table.file;
    nothing.left_out = std::move(left_out);
    return nothing;
}

/// Whether a single table has a column that numbers several intervals, in every row. A column that
/// counts more than files may have intervals numbers something else.
bool numbers_intervals(const std::vector<Block>& blocks) {
    if (blocks.size() != 1) return false;
    const Columns columns(blocks.front().table);
    if (!columns.has("interval")) return false;
    std::size_t intervals = 0;
    std::optional<double> before;
    for (const Row& row : blocks.front().table.rows) {
        const auto number = columns.value_if_any(row, "interval");
        if (!number) return false;
        if (number != before && ++intervals > most_intervals) return false;
        before = number;
    }
    return intervals > 1;
}

/// The user's roles with the numbers of intervals in place of the names that a column has for them.
FileFormat with_numbers(FileFormat format, const BlockFile& file) {
    for (auto& [role, intervals] : format.roles)
        for (int number = 1; !file.fact(interval_name_key(number)).empty(); ++number)
            if (std::ranges::count(intervals, file.fact(interval_name_key(number))) > 0)
                intervals.push_back(std::to_string(number));
    return format;
}

}  // namespace

Recording recording_of(const BlockFile& file, const FileFormat& format) {
    if (file.layout == "plain" && file.blocks.size() == 1) {
        Recording recording = recording_of_table(file.blocks.front(), with_numbers(format, file));
        for (const Remark& rows : file.skipped)
            leave_out(recording.left_out, rows);
        return recording;
    }
    Recording whole;
    whole.file = file.file;
    const std::vector<Block> divided =
        numbers_intervals(file.blocks) ? intervals_of(file.blocks.front()) : std::vector<Block>{};
    const std::vector<Block>& blocks = divided.empty() ? file.blocks : divided;
    const bool own_numbers = numbers_tell_apart(blocks);
    std::string first_error;
    int count = 0;
    for (const Block& block : blocks) {
        ++count;
        if (block.table.rows.empty()) continue;
        const auto lines = lines_of(block.table.rows.front(), block.table.rows.back());
        if (has_other_role(block, format, file.file, lines, whole.left_out)) continue;
        const Columns columns(block.table);
        std::optional<RecordingRows> rows;
        try {
            rows.emplace(columns);
        } catch (const InputError& error) {
            if (first_error.empty()) first_error = error.what();
            leave_out(whole.left_out, {.kind = Remark::Kind::lacks_column,
                                       .files = {file.file},
                                       .lines = lines,
                                       .names = {name_of(block)}});
            continue;
        }
        const IntervalSeries part = finished_rows(block, columns, *rows, whole.left_out);
        if (part.size() > 0) append_interval(whole, part, own_numbers ? block.number : count);
    }
    if (whole.size() == 0 && !first_error.empty())
        throw InputError(first_error +
                         "; steady shear needs time, torque or shear stress, normal force or "
                         "normal stress, gap, and the lid's speed in one interval. 'pendular "
                         "import FILE' shows what the file has");
    if (whole.size() > 0 &&
        (whole.shear().empty() || (whole.normal_force.empty() && whole.normal_stress.empty()) ||
         (whole.angular_velocity.empty() && whole.shear_velocity.empty())))
        throw InputError({file.file},
                         "some intervals have torque, normal force or angular velocity and others "
                         "only stresses or the speed at the mean radius; export all intervals with "
                         "the same columns");
    for (const Remark& rows : file.skipped)
        leave_out(whole.left_out, rows);
    return whole;
}

Recording read_recording(const std::filesystem::path& path, const FileFormat& format) {
    return recording_of(read_blocks(path, format), format);
}

void fill_from_stresses(Recording& recording, const AnnularCell& cell) {
    if (recording.torque.empty() && recording.shear_stress.empty()) {
        if (!recording.lever_force.empty() && !(cell.lever_arm > 0))
            throw InputError({recording.file},
                             "has the force on a lever in place of a torque; state the distance of "
                             "the load cell from the axis in [cell] of study.toml, as in lever_arm "
                             "= \"0.2 m\"");
        for (const double force : recording.lever_force)
            recording.torque.push_back(force * cell.lever_arm);
    }
    if (recording.torque.empty())
        for (const double stress : recording.shear_stress)
            recording.torque.push_back(torque(stress, cell));
    if (recording.normal_force.empty())
        for (const double stress : recording.normal_stress)
            recording.normal_force.push_back(normal_force(stress, cell));
    if (recording.angular_velocity.empty())
        for (const double velocity : recording.shear_velocity)
            recording.angular_velocity.push_back(2 * velocity /
                                                 (cell.inner_radius + cell.outer_radius));
}

}  // namespace pendular
