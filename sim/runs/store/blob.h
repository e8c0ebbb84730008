#pragma once

#include <string>

namespace pendular {

/// Returns bytes compressed by zlib.
std::string compressed(const std::string& bytes);
/// Returns the bytes that `compressed` compressed.
/// @throws std::runtime_error if the bytes are not valid zlib data, or if n compressed bytes expand
///         to more than 100 n + 65536 bytes
std::string expanded(const std::string& bytes);

}  // namespace pendular
