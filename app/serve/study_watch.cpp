#include "app/serve/study_watch.h"

#include <sys/stat.h>

#include <exception>
#include <utility>

#include "data/files/file_access.h"
#include "data/files/text_file.h"
#include "data/study/study.h"
#include "workflow/study_input.h"

namespace pendular::app {
namespace {

namespace fs = std::filesystem;

using Stamps = std::map<std::string, FileStamp>;

void add_stamp(Stamps& stamps, const fs::path& file) {
    struct stat status = {};
    if (stat(file.c_str(), &status) != 0) return;
    stamps[file.lexically_normal().string()] = {.size = status.st_size,
                                                .seconds = status.st_mtim.tv_sec,
                                                .nanoseconds = status.st_mtim.tv_nsec,
                                                .number = status.st_ino};
}

/// Whether a pattern leads out of the folder to which it is relative.
bool leads_outside(const fs::path& pattern) {
    const fs::path normal = pattern.lexically_normal();
    return normal.is_absolute() || normal.empty() || *normal.begin() == "..";
}

std::vector<std::string> changes(const Stamps& before, const Stamps& after) {
    std::vector<std::string> added, other;
    const auto name = [](const std::string& path) {
        return printable(fs::path(path).filename().string());
    };
    for (const auto& [path, stamp] : after) {
        const auto earlier = before.find(path);
        if (earlier == before.end()) {
            added.push_back(name(path) + " is new");
        } else if (earlier->second != stamp) {
            other.push_back(name(path) + " has changed");
        }
    }
    for (const auto& [path, stamp] : before)
        if (!after.contains(path)) other.push_back(name(path) + " is gone");
    added.insert(added.end(), other.begin(), other.end());
    return added;
}

}  // namespace

std::vector<std::string> changes_between(const StudyStamps& before, const StudyStamps& after) {
    auto found = changes(before.inputs, after.inputs);
    return found.empty() ? changes(before.results, after.results) : found;
}

StudyWatch::StudyWatch(fs::path study, fs::path results)
    : file_(study_folder(study) / (fs::is_directory(study) ? "study.toml" : study.filename())),
      results_(std::move(results)) {}

StudyStamps StudyWatch::look() {
    const std::scoped_lock lock(mutex_);
    StudyStamps stamps;
    add_stamp(stamps.inputs, file_);
    if (!stamps.inputs.empty() && stamps.inputs.begin()->second != stamp_) {
        read_patterns_anew();
        stamp_ = stamps.inputs.begin()->second;
    }
    for (const std::string& pattern : patterns_) {
        try {
            for (const fs::path& file : matching_files(file_.parent_path(), pattern))
                add_stamp(stamps.inputs, file);
        } catch (const std::invalid_argument&) {
            continue;  // the diagnosis of the study refuses a pattern of too many folders
        }
    }
    for (const char* const name : {"fit.json", "ladder.json"})
        add_stamp(stamps.results, results_ / name);
    return stamps;
}

void StudyWatch::read_patterns_anew() {
    try {
        std::vector<std::string> patterns;
        const bool outside = allows_outside(file_);
        for (const FilePattern& each : read_patterns(file_))
            if (outside || !leads_outside(each.pattern)) patterns.push_back(each.pattern);
        patterns_ = std::move(patterns);
    } catch (const std::exception&) {
        return;  // the diagnosis of the study says what is wrong with study.toml
    }
}

}  // namespace pendular::app
