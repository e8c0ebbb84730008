#pragma once

#include <filesystem>
#include <string>

namespace pendular {

/// Lock, represented by a file, that only one process at a time can have, so that no two processes
/// change a study or a checkpoint of a simulation at the same time. The destructor releases the
/// lock and removes the file. If a process is killed, the lock is released, but the file remains.
class FileLock {
  public:
    /// @param file created by `take` if it does not exist
    explicit FileLock(std::filesystem::path file) : file_(std::move(file)) {}
    FileLock(const FileLock&) = delete;
    FileLock& operator=(const FileLock&) = delete;
    ~FileLock();

    /// Takes the lock without waiting.
    /// @return false if another process has the lock
    /// @throws std::runtime_error if the file cannot be written or locked, or is a symbolic link
    bool take();
    /// Returns the process that has the lock, such as "process 123 (pendular add my-study)", or
    /// "another process" if the system does not reveal it.
    std::string holder() const;

  private:
    std::filesystem::path file_;
    int descriptor_ = -1;
};

}  // namespace pendular
