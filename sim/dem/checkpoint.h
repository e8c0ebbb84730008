#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

#include "data/files/file_access.h"

namespace pendular::dem {

/// Checkpoint file of a simulation run, from which a later process can resume the run. Neither a
/// crash nor a full disk destroys the previous checkpoint. While the object exists, no other
/// process can use the file.
///
/// The file begins with lines of text: version of the file format, checksum and number of bytes,
/// parameters of the run (one per line), and an empty line. The state of the run follows in binary.
class Checkpoint {
  public:
    /// Locks the file, which need not exist yet, by a second file with the additional extension
    /// .lock.
    /// @param every time after which the next checkpoint is due (`due`)
    /// @throws InputError if another process uses the file, if the path exists but is not a regular
    ///         file, or if the folder of the file cannot be written
    explicit Checkpoint(const std::filesystem::path& file,
                        std::chrono::duration<double> every = std::chrono::minutes(10));
    Checkpoint(const Checkpoint&) = delete;
    Checkpoint& operator=(const Checkpoint&) = delete;

    /// Returns the state of a run as bytes; empty if the file does not exist.
    /// @param run parameters of the run as lines "name = value"
    /// @throws InputError if the file belongs to a run with other parameters, has a format other
    ///         than `format`, or is truncated or corrupt; the file is left unchanged
    std::optional<std::string> read(const std::string& run) const;
    /// Replaces the file by a new state of the run.
    /// @throws std::runtime_error if the file cannot be written; the previous file is then kept
    void write(const std::string& run, const std::string& state);
    /// Deletes the file if it exists. The caller must first save the results of the complete run.
    void remove();

    bool due() const { return std::chrono::steady_clock::now() - written_ >= every_; }
    bool exists() const { return std::filesystem::exists(file_); }
    const std::filesystem::path& file() const { return file_; }

    /// Version of the file format, which must increase whenever the layout of the saved state
    /// changes. Every member that a step reads must be part of the state.
    static constexpr int format = 4;

  private:
    void lock();

    std::filesystem::path file_;
    FileLock lock_;
    std::chrono::duration<double> every_;
    std::chrono::steady_clock::time_point written_ = std::chrono::steady_clock::now();
};

}  // namespace pendular::dem
