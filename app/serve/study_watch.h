#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "data/study/study.h"

namespace pendular::app {

/// Size, time of change and inode number of a file, by which a changed file is recognised: at least
/// one of these numbers differs after the file was written or replaced.
struct FileStamp {
    /// Size of the file [bytes].
    std::int64_t size = 0;
    /// Time of the last change since 1970 [s], and its fraction [ns].
    std::int64_t seconds = 0, nanoseconds = 0;
    /// Inode number of the file on its disk.
    std::uint64_t number = 0;
    bool operator==(const FileStamp&) const = default;
};

/// State of the files from which the page of a study is made: size, time of change and inode number
/// of each file, by its path.
struct StudyStamps {
    /// State of study.toml and of each file of measurements, by path.
    std::map<std::string, FileStamp> inputs;
    /// State of fit.json and ladder.json in the results folder, by path.
    std::map<std::string, FileStamp> results;
    bool operator==(const StudyStamps&) const = default;
};

/// Returns phrases that name the files of a study which differ between two states: "dry_4.csv is
/// new", "study.toml has changed" or "dry_2.csv is gone", new files first. Results are named only
/// where study.toml and the measurements are unchanged.
std::vector<std::string> changes_between(const StudyStamps& before, const StudyStamps& after);

/// Finds changes of the files from which the page of a study is made: study.toml, the measurements
/// that its patterns match (within the study's folder, unless the study allows others), and
/// fit.json and ladder.json of the results folder. Several threads may use it at once.
class StudyWatch {
  public:
    /// Sets the files to watch; `look` reads their state.
    /// @param study folder of the study, or its study.toml
    /// @param results folder for results
    StudyWatch(std::filesystem::path study, std::filesystem::path results);
    /// Returns the present state of the files. While study.toml cannot be read, the patterns of its
    /// last readable version are used.
    StudyStamps look();

  private:
    void read_patterns_anew();

    /// Path of the watched study.toml.
    std::filesystem::path file_;
    std::filesystem::path results_;
    std::mutex mutex_;
    /// State of study.toml when `patterns_` were read from it.
    FileStamp stamp_;
    std::vector<std::string> patterns_;
};

}  // namespace pendular::app
