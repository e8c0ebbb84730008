#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "data/study/study.h"

namespace pendular::app {

/// Size, time of change and number of a file on its disk; at least one of them differs after the
/// file was written or replaced.
struct FileStamp {
    std::int64_t size = 0;                      ///< [bytes]
    std::int64_t seconds = 0, nanoseconds = 0;  ///< time of the last change
    std::uint64_t number = 0;
    bool operator==(const FileStamp&) const = default;
};

/// Stamps of the files on which the page of a study rests, by path.
struct StudyStamps {
    std::map<std::string, FileStamp> inputs;   ///< study.toml and the measurements
    std::map<std::string, FileStamp> results;  ///< files of the results folder
    bool operator==(const StudyStamps&) const = default;
};

/// Differences between two looks at a study, one phrase each: "dry_4.csv is new", "study.toml has
/// changed" or "dry_2.csv is gone"; new files come first. Results are named only where no input
/// differs.
std::vector<std::string> changes_between(const StudyStamps& before, const StudyStamps& after);

/// Looks for changes of the files on which the page of a study rests: study.toml, the measurements
/// that its patterns match (within the study's folder, unless the study allows others), and two files of the results folder.
/// Any thread may look.
class StudyWatch {
  public:
    /// @param study folder of the study, or its study.toml
    /// @param results folder for results
    StudyWatch(std::filesystem::path study, std::filesystem::path results);
    /// Present stamps of the files. While study.toml cannot be read, its last readable patterns are
    /// used.
    StudyStamps look();

  private:
    void read_patterns_anew();

    std::filesystem::path file_;  ///< study.toml
    std::filesystem::path results_;
    std::mutex mutex_;
    FileStamp stamp_;  ///< stamp of study.toml when `patterns_` were read
    std::vector<std::string> patterns_;
};

}  // namespace pendular::app
