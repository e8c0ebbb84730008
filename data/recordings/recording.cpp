#include "data/recordings/recording.h"

#include <fmt/format.h>

#include <algorithm>

#include "data/files/columns.h"
#include "data/files/formats/layouts.h"
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

/// Recording of a plain table, every row of which must be valid, without the intervals to which the
/// user gave another role.
Recording recording_of_table(const Table& table, const FileFormat& format) {
    const Columns columns(table);
    RecordingRows rows(columns);
    for (const Row& row : table.rows)
        rows.add(row);
    Recording recording{rows.finish(), table.file, 1, rows.unused_columns()};
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
    if (file.layout == "plain") return recording_of_table(file.blocks.front().table, format);
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
        add_rows(block, *rows, whole.left_out);
        const IntervalSeries part = rows->finish();
        if (part.size() > 0) append_interval(whole, part, own_numbers ? block.number : count);
    }
    if (whole.size() == 0 && !first_error.empty())
        throw InputError(first_error +
                         "; steady shear needs time, torque or shear stress, normal force or "
                         "normal stress, gap, and the lid's speed in one interval. 'pendular "
                         "import FILE' shows what the file has");
    if (whole.size() > 0 && ((whole.torque.empty() && whole.shear_stress.empty()) ||
                             (whole.normal_force.empty() && whole.normal_stress.empty()) ||
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
