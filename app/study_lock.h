#pragma once

#include <filesystem>
#include <optional>
#include <stop_token>

#include "data/files/file_lock.h"

namespace pendular::app {

/// Lock of a study, by which commands that change it follow one another. A study in a folder that
/// cannot be written is not locked, since nothing can change it.
class StudyLock {
  public:
    /// Waits until no other process has the lock, for a minute at most or for
    /// $PENDULAR_LOCK_SECONDS, and says on standard error who has it.
    /// @param folder folder of the study
    /// @throws dem::Interrupted where a stop is requested while waiting
    /// @throws std::runtime_error at the end of the time, with the process that has the lock
    StudyLock(const std::filesystem::path& folder, const std::stop_token& stop);

  private:
    std::optional<FileLock> lock_;
};

}  // namespace pendular::app
