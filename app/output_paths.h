#pragma once

#include <filesystem>
#include <string>

namespace pendular::app {

/// Checks, before a long computation, that `path` can be written, as a folder if `folder` is true,
/// else as a file. Creates nothing.
/// @throws InputError where `path` is empty or cannot be written; its text names `option`, the
///         command-line option that gave the path
void demand_writable(const std::filesystem::path& path, const std::string& option, bool folder);

/// Checks that writing to `file` replaces nothing but a table of the same kind, an earlier output
/// whose first characters are `first`.
/// @throws InputError where the file holds something else, a recording for example
void demand_table(const std::filesystem::path& file, const std::string& first);

/// Checks that writing JSON to `file`, which the option `option` names, replaces nothing but JSON.
/// @throws InputError where the file exists and holds something else, a recording for example
void demand_json(const std::filesystem::path& file, const std::string& option);

}  // namespace pendular::app
