#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string_view>

namespace pendular {

/// Reads a regular file from its begin to its end in parts of a few MB, which are handed to `read`
/// one after the other until it returns false. Returns whether the end was reached; false, too, for
/// a file of more than `largest` bytes, of which nothing is read.
/// @throws InputError if the file cannot be read or is no regular file
bool read_in_parts(const std::filesystem::path& path, std::uintmax_t largest,
                   const std::function<bool(std::string_view)>& read);

}  // namespace pendular
