#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace pendular {

/// Largest size of a file with a table, recordings for example [bytes].
constexpr std::uintmax_t largest_table = 256u << 20;
/// Largest size of a file that a person writes, such as study.toml or a campaign [bytes].
constexpr std::uintmax_t largest_settings = 1u << 20;

/// Content of a regular file. Pipes, devices, folders and files of the kernel, which may be endless
/// or wait forever, are refused.
/// @param largest greatest size that is read [bytes]
/// @throws InputError if the file cannot be read, is no regular file, or is larger than `largest`
std::string read_bytes(const std::filesystem::path& path, std::uintmax_t largest);

/// Whether a path is a symbolic link to a place outside of the folder that the link is in, or to
/// nothing.
bool leads_out(const std::filesystem::path& path);

/// Whether a file is in a folder or in one of its subfolders, once all symbolic links are resolved.
bool is_within(const std::filesystem::path& file, const std::filesystem::path& folder);

}  // namespace pendular
