#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pendular {

/// Returns a pattern of file paths that matches only a given path: the special characters of
/// patterns are escaped.
std::string as_pattern(const std::string& path);

/// Returns the existing files whose path matches a pattern with '*', '?' and '[...]', sorted by
/// path.
/// @param folder folder to which the pattern is relative, unless the pattern is an absolute path
/// @throws std::invalid_argument if more than 10,000 folders would have to be searched
std::vector<std::filesystem::path> matching_files(const std::filesystem::path& folder,
                                                  const std::string& pattern);

/// Whether the path of a file matches a pattern with '*', '?' and '[...]'. The file need not exist.
/// @param folder folder to which the pattern is relative, unless the pattern is an absolute path
bool matches(const std::filesystem::path& file, const std::filesystem::path& folder,
             const std::string& pattern);

}  // namespace pendular
