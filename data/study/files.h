#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pendular {

/// Pattern that matches one path only: special characters of patterns are escaped.
std::string as_pattern(const std::string& path);

/// Existing files whose path matches a pattern with '*', '?' and '[...]', sorted by path. The
/// pattern is relative to the folder unless it is an absolute path.
/// @throws std::invalid_argument for a pattern that opens more than 10,000 folders
std::vector<std::filesystem::path> matching_files(const std::filesystem::path& folder,
                                                  const std::string& pattern);

/// Whether the path of a file matches a pattern with '*', '?' and '[...]', relative to `folder`
/// unless it is an absolute path; the file need not exist.
bool matches(const std::filesystem::path& file, const std::filesystem::path& folder,
             const std::string& pattern);

}  // namespace pendular
