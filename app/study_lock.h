#pragma once

#include <filesystem>
#include <optional>
#include <stop_token>

#include "data/files/file_lock.h"

namespace pendular::app {

/// Lock of a study, which each command that changes the study takes first, so that these commands
/// run one after the other. A study in a folder without write permission is not locked, since no
/// command can change it.
class StudyLock {
  public:
    /// Locks a study. If another process has the lock, prints a line that names this process and
    /// waits for at most a minute or $PENDULAR_LOCK_SECONDS [s].
    /// @param folder folder of the study
    /// @throws dem::Interrupted if a stop is requested while waiting
    /// @throws std::runtime_error if another process keeps the lock for longer than the waiting
    ///         time
    StudyLock(const std::filesystem::path& folder, const std::stop_token& stop);

  private:
    std::optional<FileLock> lock_;
};

}  // namespace pendular::app
