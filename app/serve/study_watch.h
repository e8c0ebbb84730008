#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "data/study/study.h"

namespace pendular::app {

/// Size, time of change and inode number of a file, by which a changed file is recognised. Writing
/// or replacing the file changes at least one of these numbers.
struct FileStamp {
    /// Size of the file [bytes].
    std::int64_t size = 0;
    /// Time of the last change of the file since 1970: whole seconds [s] and the fraction [ns].
    std::int64_t seconds = 0, nanoseconds = 0;
    /// Inode number of the file on its disk.
    std::uint64_t number = 0;
    bool operator==(const FileStamp&) const = default;
};

/// Size, time of change and inode number of the files from which the page of a study is made.
struct StudyStamps {
    /// Stamps of study.toml and of each file of measurements. The key is the path of the file. The
    /// value is size, time of change and inode number of the file.
    std::map<std::string, FileStamp> inputs;
    /// Stamps of fit.json and ladder.json in the results folder. The key is the path of the file.
    /// The value is size, time of change and inode number of the file.
    std::map<std::string, FileStamp> results;
    bool operator==(const StudyStamps&) const = default;
};

/// Returns phrases that name the files of a study which differ between two times: "dry_4.csv is
/// new", "study.toml has changed" or "dry_2.csv is gone", new files first. Files of results are
/// named only if study.toml and the measurements are unchanged.
/// @param before stamps (size, time of change, inode number) of the files at the first time
/// @param after stamps of the files at the second time
std::vector<std::string> changes_between(const StudyStamps& before, const StudyStamps& after);

/// Watcher that finds changes of the files from which the page of a study is made: study.toml, the
/// measurements that the file patterns in study.toml match, and fit.json and ladder.json of the
/// results folder. Measurements outside of the study's folder are watched only if study.toml
/// permits measurements outside. Several threads may use one watcher at once.
class StudyWatch {
  public:
    /// Sets the study and the folder for results to watch.
    /// @param study folder of the study, or its study.toml
    /// @param results folder for results
    StudyWatch(std::filesystem::path study, std::filesystem::path results);
    /// Returns the present sizes, times of change and inode numbers of study.toml, of the files
    /// that study.toml names, and of the results. While study.toml cannot be read, the file
    /// patterns come from the last version of study.toml that could be read.
    StudyStamps look();

  private:
    void read_patterns_anew();

    /// Path of the watched study.toml.
    std::filesystem::path file_;
    std::filesystem::path results_;
    std::mutex mutex_;
    /// Size, time of change and inode number of study.toml when `patterns_` were read from
    /// study.toml.
    FileStamp stamp_;
    std::vector<std::string> patterns_;
};

}  // namespace pendular::app
