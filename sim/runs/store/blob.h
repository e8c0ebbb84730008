#pragma once

#include <string>

namespace pendular {

/// Bytes by zlib, and back.
/// @throws std::runtime_error where they are no such bytes
std::string compressed(const std::string& bytes);
std::string expanded(const std::string& bytes);

}  // namespace pendular
