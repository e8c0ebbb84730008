#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string_view>

namespace pendular {

/// Reads a regular file from beginning to end in parts of a few MB, and passes each part to `read`
/// until `read` returns false.
/// @param largest no part of a file larger than this is read [bytes]
/// @return true if the end was reached; false if `read` returned false or the file is too large
/// @throws InputError if the file cannot be read or is no regular file
bool read_in_parts(const std::filesystem::path& path, std::uintmax_t largest,
                   const std::function<bool(std::string_view)>& read);

}  // namespace pendular
