#pragma once

#include <string>

namespace pendular {

/// Returns bytes in compressed form (zlib). The function `expanded` restores the original bytes.
std::string compressed(const std::string& bytes);
/// Restores the original bytes from the compressed bytes that the function `compressed` returned
/// (zlib).
/// @throws std::runtime_error if the bytes are not valid zlib data, or expand to more than a
///         hundred times their number plus 65536
std::string expanded(const std::string& bytes);

}  // namespace pendular
