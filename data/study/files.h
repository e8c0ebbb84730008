#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pendular {

/// Files whose path relative to a folder matches a pattern with '*', '?' and '[...]', by name.
std::vector<std::filesystem::path> matching_files(const std::filesystem::path& folder,
                                                  const std::string& pattern);

/// Whether a file, which need not exist, is one that `matching_files` finds once it is there.
bool matches(const std::filesystem::path& file, const std::filesystem::path& folder,
             const std::string& pattern);

}  // namespace pendular
