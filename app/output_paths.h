#pragma once

#include <filesystem>
#include <string>

namespace pendular::app {

/// Checks, before a long computation, that a folder or a file can be written. Creates nothing.
/// @throws InputError if `path` is empty or cannot be written; the message names `option`, the
///         command-line option that gave the path
void demand_writable(const std::filesystem::path& path, const std::string& option, bool folder);

/// Checks that writing a table to `file` replaces nothing but an earlier table, whose first
/// characters are `first`. A missing or empty file is accepted.
/// @throws InputError if the file contains anything else, such as a recording
void demand_table(const std::filesystem::path& file, const std::string& first);

/// Checks that writing JSON to `file` replaces nothing but JSON, by its first character. A missing
/// or empty file is accepted.
/// @throws InputError if the file is something else, such as a recording; the message names
///         `option`
void demand_json(const std::filesystem::path& file, const std::string& option);

}  // namespace pendular::app
