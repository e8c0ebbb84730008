#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "data/study/study.h"

namespace pendular::app {

/// Stamp by which a changed file is recognised. Writing or replacing the file changes at least one
/// of these numbers.
struct FileStamp {
    std::int64_t size = 0;                      ///< [bytes]
    std::int64_t seconds = 0, nanoseconds = 0;  ///< last change since 1970 [s, ns]
    std::uint64_t number = 0;                   ///< inode number
    bool operator==(const FileStamp&) const = default;
};

/// Stamps of the files from which the page of a study is made, by their paths.
struct StudyStamps {
    std::map<std::string, FileStamp> inputs;   ///< study.toml and the files of measurements
    std::map<std::string, FileStamp> results;  ///< fit.json and ladder.json
    bool operator==(const StudyStamps&) const = default;
};

/// Returns phrases that name the files that differ between two times: "dry_4.csv is new",
/// "study.toml has changed" or "dry_2.csv is gone", new files first. Results are named only if
/// study.toml and the measurements are unchanged.
std::vector<std::string> changes_between(const StudyStamps& before, const StudyStamps& after);

/// Finds changes of study.toml, of the measurements that its file patterns match, and of fit.json
/// and ladder.json in the results folder. Measurements outside of the study's folder are watched
/// only if study.toml permits them. Several threads may use one watcher at once.
class StudyWatch {
  public:
    /// @param study folder of the study, or its study.toml
    StudyWatch(std::filesystem::path study, std::filesystem::path results);
    /// Returns the present stamps. While study.toml cannot be read, the file patterns come from the
    /// last version of it that could be read.
    StudyStamps look();

  private:
    void read_patterns_anew();

    std::filesystem::path file_;  ///< study.toml
    std::filesystem::path results_;
    std::mutex mutex_;
    FileStamp stamp_;  ///< of study.toml when `patterns_` were read
    std::vector<std::string> patterns_;
};

}  // namespace pendular::app
