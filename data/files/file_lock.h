#pragma once

#include <filesystem>
#include <string>

namespace pendular {

/// Lock that one process at a time has, as the file `file`, which is removed with the lock. A
/// process that is killed leaves the file without the lock.
class FileLock {
  public:
    explicit FileLock(std::filesystem::path file) : file_(std::move(file)) {}
    FileLock(const FileLock&) = delete;
    FileLock& operator=(const FileLock&) = delete;
    ~FileLock();

    /// Takes the lock, without waiting.
    /// @return false where another process has it
    /// @throws std::runtime_error where the file cannot be written, or is a link
    bool take();
    /// Process that has the lock, as "process 123 (pendular add my-study)" or, where the system
    /// does not say which it is, "another process".
    std::string holder() const;

  private:
    std::filesystem::path file_;
    int descriptor_ = -1;
};

}  // namespace pendular
