#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace pendular {

/// Largest size of a file with a table that is read as a whole [bytes]. Simple recordings, which
/// `quick_recording` reads in parts, may be larger.
constexpr std::uintmax_t largest_table = 256u << 20;
/// Largest size of a file written by hand, such as study.toml or a campaign, that the program reads
/// [bytes].
constexpr std::uintmax_t largest_settings = 1u << 20;

/// Returns the content of a regular file. Pipes, devices, folders and files of the kernel are
/// refused, since reading them may never end.
/// @param largest largest size that is read [bytes]
/// @throws InputError if the file cannot be read, is no regular file, or is larger than `largest`
std::string read_bytes(const std::filesystem::path& path, std::uintmax_t largest);

/// Whether a path is a symbolic link whose target does not exist or is outside of the folder of the
/// link.
bool links_outside(const std::filesystem::path& path);

/// Whether a file is in a folder or in one of its subfolders, after all symbolic links are
/// resolved.
bool is_within(const std::filesystem::path& file, const std::filesystem::path& folder);

}  // namespace pendular
