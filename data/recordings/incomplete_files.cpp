#include "data/recordings/incomplete_files.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <map>

#include "data/recordings/replicate_groups.h"

namespace pendular {
namespace {

using Steps = std::vector<const Reading*>;
using ExcludedRows = std::vector<const Excluded*>;

/// Readings and excluded rows of one recording.
struct FileContent {
    std::filesystem::path file;
    Steps steps;
    ExcludedRows excluded;  ///< in the order of the lines

    std::string name() const { return file.filename().string(); }
};

std::map<std::string, FileContent> content_by_file(const Measurements& measurements) {
    std::map<std::string, FileContent> files;
    for (const Reading& reading : measurements.readings)
        files[reading.origin.file].steps.push_back(&reading);
    for (const Excluded& rows : measurements.excluded)
        files[rows.origin.file].excluded.push_back(&rows);
    for (auto& [name, content] : files) {
        content.file = name;
        std::ranges::stable_sort(content.excluded, {},
                                 [](const Excluded* rows) { return rows->origin.line; });
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

/// Excluded rows after the last step of a file that gave a reading.
ExcludedRows excluded_after(const FileContent& content) {
    const int last = std::max(content.steps.back()->last_line, content.steps.back()->origin.line);
    ExcludedRows rest;
    std::ranges::copy_if(content.excluded, std::back_inserter(rest),
                         [&](const Excluded* rows) { return rows->origin.line > last; });
    return rest;
}

/// Note on a file that ends before a longer file with the same first steps; empty if the file was
/// not cut off there.
std::string note_on_end(const FileContent& file, const FileContent& longer) {
    const ExcludedRows rest = excluded_after(file);
    if (rest.empty()) {
        return fmt::format(
            "{} ends after step {}, {} goes on to step {} from the same beginning. If the "
            "measurement was not stopped there, the file was cut off: export it again.",
            file.name(), file.steps.back()->step, longer.name(), longer.steps.back()->step);
    }
    // Rows of further steps: the file goes on.
    const std::string step = fmt::format("step {}", longer.steps[file.steps.size()]->step);
    const std::string before = step + ": ";
    if (!std::ranges::all_of(
            rest, [&](const Excluded* rows) { return rows->reason.starts_with(before); }))
        return "";
    return fmt::format(
        "{} gives no reading at {} ({}), but {} does. If the recording ends too early, the file "
        "was "
        "cut off: export it again.",
        file.name(), step, rest.back()->reason.substr(before.size()), longer.name());
}

/// Whether a file gave no reading for another reason than one that a warning or study.toml states.
bool is_lost(const FileContent& content) {
    return content.steps.empty() && !content.excluded.empty() &&
           std::ranges::none_of(content.excluded, [](const Excluded* rows) {
               const std::string& reason = rows->reason;
               return reason.starts_with("set aside") || reason.starts_with("repeats") ||
                      reason.ends_with(", as stated");
           });
}

/// Why a file gave no reading: the reason of the longest range of excluded rows.
std::string reason_of(const FileContent& content) {
    return (*std::ranges::max_element(
                content.excluded, {},
                [](const Excluded* rows) { return rows->last_line - rows->origin.line; }))
        ->reason;
}

/// Note on recordings of which no step gave a reading; empty if each gave one.
std::string note_on_lost_files(const std::map<std::string, FileContent>& files) {
    std::vector<std::string> lost;
    constexpr std::size_t most = 3;
    for (const auto& [name, content] : files) {
        if (is_lost(content))
            lost.push_back(fmt::format("{} ({})", content.name(), reason_of(content)));
    }
    if (lost.empty()) return "";
    const std::size_t more = lost.size() > most ? lost.size() - most : 0;
    lost.resize(lost.size() - more);
    return fmt::format("No step gave a reading in {}{}.", fmt::join(lost, ", "),
                       more > 0 ? fmt::format(" and in {} more recordings", more) : "");
}

}  // namespace

std::vector<std::string> notes_on_incomplete_files(const Study& study,
                                                   const Measurements& measurements) {
    std::vector<std::string> notes;
    const auto add = [&](const std::string& note) {
        if (!note.empty()) notes.push_back(note);
    };
    auto content = content_by_file(measurements);
    for (const Source& source : study.sources) {
        if (source.kind == Source::Kind::recording) continue;
        for (const auto& file : source.files)
            content.erase(file.string());
    }
    if (!measurements.readings.empty()) add(note_on_lost_files(content));
    for (const Source& source : study.sources) {
        std::vector<const FileContent*> files;
        for (const auto& file : source.files) {
            const auto found = content.find(file.string());
            if (found != content.end()) files.push_back(&found->second);
        }
        for (const FileContent* file : files) {
            const auto longer = std::ranges::find_if(
                files, [&](const FileContent* other) { return begins(file->steps, other->steps); });
            if (longer != files.end()) add(note_on_end(*file, **longer));
        }
    }
    return notes;
}

}  // namespace pendular
