#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace pendular {

/// Byte of a line at which each of its cells begins, and one behind the last delimiter that it
/// could have.
std::vector<std::size_t> bytes_of_cells(std::string_view line, char delimiter);

/// Number of the characters of a text in UTF-8.
std::size_t characters_in(std::string_view text);

}  // namespace pendular
