#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

namespace pendular::dem {

/// Checkpoint file of a run, from which a later process resumes the run. It is replaced as a whole
/// and is on the disk when `write` returns, so that neither a crash nor a full disk costs the
/// former one. While the object lives no other process can use the file.
///
/// The file begins with text: its format, checksum and length, then the run's parameters, a line
/// each, and an empty line; the state follows in binary.
class Checkpoint {
  public:
    /// Locks the file through FILE.lock beside it; the file itself need not exist.
    /// @throws InputError where another process uses it or its folder cannot be written
    explicit Checkpoint(const std::filesystem::path& file,
                        std::chrono::duration<double> every = std::chrono::minutes(10));
    ~Checkpoint();
    Checkpoint(const Checkpoint&) = delete;
    Checkpoint& operator=(const Checkpoint&) = delete;

    /// Last saved state of the run that these lines "name = value" describe; empty where there is
    /// no file.
    /// @throws InputError where the file is of another run, another version or not whole; the file
    /// is left alone
    std::optional<std::string> read(const std::string& run) const;
    /// @throws std::runtime_error where it cannot be written; the former one is then still there
    void write(const std::string& run, const std::string& state);
    /// Deletes the file: the run is done and its results are safe.
    void remove();

    bool due() const { return std::chrono::steady_clock::now() - written_ >= every_; }
    bool exists() const { return std::filesystem::exists(file_); }
    const std::filesystem::path& file() const { return file_; }

    static constexpr int format = 3;  ///< raised whenever what a run saves changes

  private:
    void lock();

    std::filesystem::path file_, lock_file_;
    std::chrono::duration<double> every_;
    std::chrono::steady_clock::time_point written_ = std::chrono::steady_clock::now();
    int lock_ = -1;
};

}  // namespace pendular::dem
