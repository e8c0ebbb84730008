#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace pendular {

/// Largest file with a table that is read as a whole [bytes]. Chosen: cells take many times their
/// text in memory. Simple recordings, which `quick_recording` reads in parts, may be larger.
constexpr std::uintmax_t largest_table = 256u << 20;
/// Largest file written by hand, such as study.toml or a campaign [bytes]. Chosen: nobody writes
/// as much.
constexpr std::uintmax_t largest_settings = 1u << 20;

/// Returns the content of a regular file. Pipes, devices, folders and files of the kernel are
/// refused, since reading them may never end.
/// @throws InputError if the file cannot be read, is no regular file, or is larger than `largest`
///         [bytes]
std::string read_bytes(const std::filesystem::path& path, std::uintmax_t largest);

/// Reads a regular file from beginning to end in parts of a few MB, and passes each part to `read`
/// until `read` returns false.
/// @param largest no part of a file larger than this is read [bytes]
/// @return true if the end was reached; false if `read` returned false or the file is too large
/// @throws InputError if the file cannot be read or is no regular file
bool read_in_parts(const std::filesystem::path& path, std::uintmax_t largest,
                   const std::function<bool(std::string_view)>& read);

/// Whether a path is a symbolic link whose target is missing or outside of the link's folder.
bool links_outside(const std::filesystem::path& path);

/// Whether a file is in a folder or its subfolders, after all symbolic links are resolved.
bool is_within(const std::filesystem::path& file, const std::filesystem::path& folder);

/// Returns a pattern that matches only a given path, with the special characters escaped.
std::string as_pattern(const std::string& path);

/// Returns the existing files that match a pattern with '*', '?' and '[...]', sorted by path, with
/// numbers by their value.
/// @param folder folder to which the pattern is relative, unless the pattern is an absolute path
/// @throws std::invalid_argument if more than 10,000 folders would have to be searched
std::vector<std::filesystem::path> matching_files(const std::filesystem::path& folder,
                                                  const std::string& pattern);

/// Whether a file, which need not exist, matches a pattern as in `matching_files`.
bool matches(const std::filesystem::path& file, const std::filesystem::path& folder,
             const std::string& pattern);

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
