#include "data/recordings/incomplete_files.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "data/recordings/replicate_groups.h"

namespace pendular {
namespace {

using Steps = std::vector<const Reading*>;

Steps steps_of(const std::filesystem::path& file, const std::vector<Reading>& readings) {
    Steps steps;
    for (const Reading& reading : readings) {
        if (reading.origin.file == file.string()) steps.push_back(&reading);
    }
    return steps;
}

/// Whether the steps of a file are the first steps of a longer file.
bool begins(const Steps& file, const Steps& longer) {
    return !file.empty() && file.size() < longer.size() &&
           std::equal(file.begin(), file.end(), longer.begin(),
                      [](const Reading* a, const Reading* b) {
                          return a->step == b->step && are_replicates(*a, *b);
                      });
}

/// Excluded rows after the last reading of a file; null if there are none.
const Excluded* excluded_after(const Steps& file, const Measurements& measurements) {
    const Position& last = file.back()->origin;
    const auto found = std::ranges::find_if(measurements.excluded, [&](const Excluded& rows) {
        return rows.origin.file == last.file && rows.origin.line > last.line;
    });
    return found == measurements.excluded.end() ? nullptr : &*found;
}

std::string name_of(const Steps& steps) {
    return std::filesystem::path(steps.front()->origin.file).filename().string();
}

/// Note on a file that ends before a longer file with the same first steps; empty if the file was
/// not cut off there.
std::string note_on_end(const Steps& file, const Steps& longer, const Measurements& measurements) {
    const Excluded* const rest = excluded_after(file, measurements);
    if (rest == nullptr) {
        return fmt::format(
            "{} ends after step {}, {} goes on to step {} from the same beginning. If the "
            "measurement was not stopped there, the file was cut off: export it again.",
            name_of(file), file.back()->step, name_of(longer), longer.back()->step);
    }
    const std::string step = fmt::format("step {}", longer[file.size()]->step);
    const std::string before = step + ": ";
    if (!rest->reason.starts_with(before)) return "";
    return fmt::format(
        "{} gives no reading at {} ({}), but {} does. If the recording ends too early, the file "
        "was "
        "cut off: export it again.",
        name_of(file), step, rest->reason.substr(before.size()), name_of(longer));
}

/// Note on recordings of which no step gave a reading; empty if each gave one.
std::string note_on_lost_files(const Study& study, const Measurements& measurements) {
    std::vector<std::string> lost;
    std::string reason;
    for (const Source& source : study.sources) {
        if (source.kind != Source::Kind::recording) continue;
        for (const auto& file : source.files) {
            if (!steps_of(file, measurements.readings).empty()) continue;
            lost.push_back(file.filename().string());
            const auto rows = std::ranges::find_if(
                measurements.excluded,
                [&](const Excluded& each) { return each.origin.file == file.string(); });
            if (reason.empty() && rows != measurements.excluded.end()) reason = rows->reason;
        }
    }
    if (lost.empty()) return "";
    constexpr std::size_t most = 3;
    std::string names = fmt::format(
        "{}", fmt::join(lost.begin(), lost.begin() + std::min(most, lost.size()), ", "));
    if (lost.size() > most) names += fmt::format(" and {} more", lost.size() - most);
    return fmt::format(
        "No step of {} gave a reading{}.", names,
        reason.empty()
            ? ""
            : fmt::format(" ({}{})", lost.size() > 1 ? lost.front() + ", " : "", reason));
}

}  // namespace

std::vector<std::string> notes_on_incomplete_files(const Study& study,
                                                   const Measurements& measurements) {
    std::vector<std::string> notes;
    const auto add = [&](const std::string& note) {
        if (!note.empty()) notes.push_back(note);
    };
    if (!measurements.readings.empty()) add(note_on_lost_files(study, measurements));
    for (const Source& source : study.sources) {
        if (source.kind != Source::Kind::recording) continue;
        std::vector<Steps> files;
        for (const auto& file : source.files)
            files.push_back(steps_of(file, measurements.readings));
        for (const Steps& file : files) {
            const auto longer = std::ranges::find_if(
                files, [&](const Steps& other) { return begins(file, other); });
            if (longer != files.end()) add(note_on_end(file, *longer, measurements));
        }
    }
    return notes;
}

}  // namespace pendular
