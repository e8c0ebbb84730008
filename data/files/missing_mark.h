#pragma once

#include <string>
#include <string_view>

namespace pendular {

/// Returns a text with its ASCII letters in lower case.
std::string in_small_letters(std::string_view text);

/// Whether a cell states that there is no value: it is empty, or reads "NaN", "NA", "n/a", "#N/A",
/// "null", "---", "***" or the like.
bool marks_no_value(std::string_view cell);

}  // namespace pendular
