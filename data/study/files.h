#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pendular {

/// Existing files whose path matches a pattern with '*', '?' and '[...]', sorted by path. The
/// pattern is relative to the folder unless it is an absolute path.
std::vector<std::filesystem::path> matching_files(const std::filesystem::path& folder,
                                                  const std::string& pattern);

/// Whether `matching_files` finds this file, or would find it if it existed.
bool matches(const std::filesystem::path& file, const std::filesystem::path& folder,
             const std::string& pattern);

}  // namespace pendular
