#include "data/recordings/cut_files.h"

#include <fmt/format.h>

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

/// Whether rows after the last step of a file were excluded, so that the file was not cut off
/// there.
bool goes_on(const Steps& file, const Measurements& measurements) {
    const Position& last = file.back()->origin;
    return std::ranges::any_of(measurements.excluded, [&](const Excluded& rows) {
        return rows.origin.file == last.file && rows.origin.line > last.line;
    });
}

std::string name_of(const Steps& steps) {
    return std::filesystem::path(steps.front()->origin.file).filename().string();
}

}  // namespace

std::vector<std::string> notes_on_cut_files(const Study& study, const Measurements& measurements) {
    std::vector<std::string> notes;
    for (const Source& source : study.sources) {
        if (source.kind != Source::Kind::recording) continue;
        std::vector<Steps> files;
        for (const auto& file : source.files)
            files.push_back(steps_of(file, measurements.readings));
        for (const Steps& file : files) {
            const auto longer = std::ranges::find_if(
                files, [&](const Steps& other) { return begins(file, other); });
            if (longer == files.end() || goes_on(file, measurements)) continue;
            notes.push_back(fmt::format(
                "{} ends after step {}, {} goes on to step {} from the same beginning. If the "
                "measurement was not stopped there, the file was cut off: export it again.",
                name_of(file), file.back()->step, name_of(*longer), longer->back()->step));
        }
    }
    return notes;
}

}  // namespace pendular
