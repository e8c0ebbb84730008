#pragma once

#include <string>

namespace pendular {

/// Returns bytes in compressed form (zlib); the function `expanded` restores them.
std::string compressed(const std::string& bytes);
/// Returns the bytes that the function `compressed` compressed (zlib).
/// @throws std::runtime_error if the bytes are not valid zlib data, or expand to more than a
///         hundred times their number
std::string expanded(const std::string& bytes);

}  // namespace pendular
