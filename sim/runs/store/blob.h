#pragma once

#include <string>

namespace pendular {

/// Compresses bytes with zlib and returns the compressed bytes. The function `expanded` restores
/// the original bytes.
std::string compressed(const std::string& bytes);
/// Restores the original bytes from the compressed bytes that the function `compressed` returned
/// (zlib).
/// @throws std::runtime_error if the bytes are not valid zlib data, or if n compressed bytes expand
///         to more than 100 n + 65536 bytes
std::string expanded(const std::string& bytes);

}  // namespace pendular
