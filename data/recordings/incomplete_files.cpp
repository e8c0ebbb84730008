#include "data/recordings/checks.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "data/recordings/reading_groups.h"

namespace pendular {
namespace {

using Steps = std::vector<const Reading*>;
using LeftOut = std::vector<const Remark*>;
using Kind = Remark::Kind;

/// Readings of one recording, and what was left out of it.
struct FileContent {
    std::string file;
    Steps steps;
    LeftOut left_out;  ///< in the order of the lines
};

std::map<std::string, FileContent> content_by_file(const Measurements& measurements) {
    std::map<std::string, FileContent> files;
    for (const Reading& reading : measurements.readings)
        files[reading.origin.file].steps.push_back(&reading);
    for (const Remark& rows : measurements.remarks)
        if (rows.outcome == Remark::Outcome::left_out) files[rows.file()].left_out.push_back(&rows);
    for (auto& [name, content] : files) {
        content.file = name;
        std::ranges::stable_sort(content.left_out, {},
                                 [](const Remark* rows) { return rows->first_line(); });
    }
    return files;
}

/// Whether the steps of a file are the first steps of a longer file.
bool begins(const Steps& file, const Steps& longer) {
    return !file.empty() && file.size() < longer.size() &&
           std::equal(file.begin(), file.end(), longer.begin(),
                      [](const Reading* a, const Reading* b) {
                          return a->step == b->step && are_replicates(*a, *b);
                      });
}

/// Last line of the last step of a file that gave a reading; 0 where none did.
int last_line_of_steps(const FileContent& content) {
    if (content.steps.empty()) return 0;
    return std::max(content.steps.back()->last_line, content.steps.back()->origin.line);
}

/// Rows left out after the last step of a file that gave a reading.
LeftOut left_out_after(const FileContent& content) {
    const int last = last_line_of_steps(content);
    LeftOut rest;
    // The begin of a row shows no further step, nor do means below the table.
    std::ranges::copy_if(content.left_out, std::back_inserter(rest), [&](const Remark* rows) {
        return rows->first_line() > last && rows->kind != Kind::cut_short &&
               rows->kind != Kind::after_interval;
    });
    return rest;
}

/// Remark on a file that ends before a longer file with the same first steps; empty if the file was
/// not cut off there.
std::optional<Remark> cut_off(const FileContent& file, const FileContent& longer) {
    const LeftOut rest = left_out_after(file);
    Remark found{.kind = Kind::ends_early,
                 .files = {file.file, longer.file},
                 .step = file.steps.back()->step,
                 .count = static_cast<std::size_t>(longer.steps.back()->step)};
    if (rest.empty()) return found;
    // Rows of further steps: the file goes on.
    found.kind = Kind::lacks_step;
    found.step = longer.steps[file.steps.size()]->step;
    if (!std::ranges::all_of(rest, [&](const Remark* rows) {
            return on_step(rows->kind) && rows->step == found.step;
        }))
        return std::nullopt;
    found.because = {*rest.back()};
    return found;
}

/// Remark on a file that ends within a row; empty for others.
std::optional<Remark> cut_within_row(const std::string& file, const FileContent& content) {
    // Among other rows, kept or left out, a short row is no sign of an end.
    int last = last_line_of_steps(content);
    for (const Remark* rows : content.left_out)
        if (rows->kind != Kind::cut_short) last = std::max(last, rows->last_line());
    const auto cut = std::ranges::find_if(content.left_out, [&](const Remark* rows) {
        return rows->kind == Kind::cut_short && rows->first_line() > last;
    });
    if (cut == content.left_out.end()) return std::nullopt;
    return Remark{.kind = Kind::ends_early, .files = {file}, .lines = (*cut)->lines};
}

/// Whether rows were left out for a reason that a warning or study.toml states.
bool is_told(Kind kind) {
    return kind == Kind::copied_rows || kind == Kind::stated_role ||
           kind == Kind::contradicting_row ||
           (kind >= Kind::repeated_reading && kind <= Kind::impossible_reading);
}

/// Recordings of which no step gave a reading, with the reason of the longest range of rows; empty
/// if each gave one.
std::optional<Remark> recordings_without_reading(const std::map<std::string, FileContent>& files) {
    Remark found{.kind = Kind::recordings_without_reading, .count = 0};
    constexpr std::size_t most = 3;  // reasons in the message, beside the number of recordings
    for (const auto& [name, content] : files) {
        const bool told = std::ranges::any_of(
            content.left_out, [](const Remark* rows) { return is_told(rows->kind); });
        if (!content.steps.empty() || content.left_out.empty() || told) continue;
        if (++found.count > most) continue;
        found.because.push_back(**std::ranges::max_element(
            content.left_out, {},
            [](const Remark* rows) { return rows->last_line() - rows->first_line(); }));
    }
    return found.count > 0 ? std::optional(found) : std::nullopt;
}

}  // namespace

std::vector<Remark> incomplete_files(const Study& study, const Measurements& measurements) {
    std::vector<Remark> found;
    const auto add = [&](std::optional<Remark> remark) {
        if (remark) found.push_back(*std::move(remark));
    };
    auto content = content_by_file(measurements);
    for (const Source& source : study.sources) {
        if (source.kind == Source::Kind::recording) continue;
        for (const auto& file : source.files)
            content.erase(file.string());
    }
    if (!measurements.readings.empty()) add(recordings_without_reading(content));
    for (const Source& source : study.sources) {
        std::vector<const FileContent*> files;
        for (const auto& file : source.files) {
            const auto known = content.find(file.string());
            if (known != content.end()) files.push_back(&known->second);
        }
        for (const FileContent* file : files) {
            const auto longer = std::ranges::find_if(
                files, [&](const FileContent* other) { return begins(file->steps, other->steps); });
            const auto off = longer == files.end() ? std::nullopt : cut_off(*file, **longer);
            add(off && off->kind == Kind::ends_early ? off : cut_within_row(file->file, *file));
            if (off && off->kind != Kind::ends_early) add(off);
        }
    }
    return found;
}

}  // namespace pendular
