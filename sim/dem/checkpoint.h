#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

#include "data/files/file_lock.h"

namespace pendular::dem {

/// Checkpoint file of a run, from which a later process resumes the run. `write` replaces the file
/// as a whole and returns once it is on the disk, so that neither a crash nor a full disk destroys
/// the previous checkpoint. While the object exists, no other process can use the file.
///
/// The file begins with lines of text: its format, its checksum and length, the run's parameters,
/// one per line, and an empty line. The state follows in binary.
class Checkpoint {
  public:
    /// Locks the file through FILE.lock beside it; the file itself need not exist. `every` is the
    /// time from one checkpoint to the next (`due`).
    /// @throws InputError where another process uses the file, where it is not a regular file, or
    /// where its folder cannot be written
    explicit Checkpoint(const std::filesystem::path& file,
                        std::chrono::duration<double> every = std::chrono::minutes(10));
    Checkpoint(const Checkpoint&) = delete;
    Checkpoint& operator=(const Checkpoint&) = delete;

    /// Returns the last saved state, as bytes, of the run whose parameters are the lines
    /// "name = value" in `run`; empty where the checkpoint file does not exist.
    /// @throws InputError where the file belongs to another run, has another format, or is
    /// truncated or corrupt; the file is left unchanged
    std::optional<std::string> read(const std::string& run) const;
    /// Replaces the checkpoint file by one with the state `state`, as bytes, of the run whose
    /// parameters are the lines "name = value" in `run`.
    /// @throws std::runtime_error where the file cannot be written; the previous one is then kept
    void write(const std::string& run, const std::string& state);
    /// Deletes the checkpoint file if it exists; for callers whose run is complete and saved.
    void remove();

    bool due() const { return std::chrono::steady_clock::now() - written_ >= every_; }
    bool exists() const { return std::filesystem::exists(file_); }
    const std::filesystem::path& file() const { return file_; }

    /// Version of the checkpoint file's format, raised whenever the layout of the saved state
    /// changes.
    static constexpr int format = 3;

  private:
    void lock();

    std::filesystem::path file_;
    FileLock lock_;
    std::chrono::duration<double> every_;
    std::chrono::steady_clock::time_point written_ = std::chrono::steady_clock::now();
};

}  // namespace pendular::dem
