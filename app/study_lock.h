#pragma once

#include <filesystem>
#include <optional>
#include <stop_token>

#include "data/files/file_lock.h"

namespace pendular::app {

/// Lock of a study: commands that change the study run one after the other. A study in a folder
/// that cannot be written is not locked, since no command can change it.
class StudyLock {
  public:
    /// Waits until no other process has the lock, for at most a minute or $PENDULAR_LOCK_SECONDS,
    /// and names the process that has it on standard error.
    /// @param folder folder of the study
    /// @throws dem::Interrupted where a stop is requested while waiting
    /// @throws std::runtime_error at the end of this time, naming the process that has the lock
    StudyLock(const std::filesystem::path& folder, const std::stop_token& stop);

  private:
    std::optional<FileLock> lock_;
};

}  // namespace pendular::app
