#pragma once

#include <filesystem>
#include <string>

namespace pendular {

/// Lock that only one process at a time can hold, by means of the file `file`. The destructor
/// releases the lock and removes the file. A process that is killed releases the lock but leaves
/// the file.
class FileLock {
  public:
    explicit FileLock(std::filesystem::path file) : file_(std::move(file)) {}
    FileLock(const FileLock&) = delete;
    FileLock& operator=(const FileLock&) = delete;
    ~FileLock();

    /// Takes the lock, without waiting.
    /// @return false where another process has the lock
    /// @throws std::runtime_error where the file cannot be written or is a symbolic link
    bool take();
    /// Name of the process that has the lock, as in "process 123 (pendular add my-study)"; "another
    /// process" where the system does not tell which process it is.
    std::string holder() const;

  private:
    std::filesystem::path file_;
    int descriptor_ = -1;
};

}  // namespace pendular
