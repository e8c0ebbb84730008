#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

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

}  // namespace pendular
