#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pendular {

/// Returns a pattern that matches only a given path, with the special characters escaped.
std::string as_pattern(const std::string& path);

/// Returns the existing files that match a pattern with '*', '?' and '[...]', sorted by path.
/// @param folder folder to which the pattern is relative, unless the pattern is an absolute path
/// @throws std::invalid_argument if more than 10,000 folders would have to be searched
std::vector<std::filesystem::path> matching_files(const std::filesystem::path& folder,
                                                  const std::string& pattern);

/// Whether a file, which need not exist, matches a pattern as in `matching_files`.
bool matches(const std::filesystem::path& file, const std::filesystem::path& folder,
             const std::string& pattern);

}  // namespace pendular
