#pragma once

#include <string>
#include <string_view>

namespace pendular {

/// Returns a text from a file in a form that is safe to show on a terminal: control characters
/// other than LF and tab, characters that change the direction of writing, and bytes that are not
/// UTF-8 are replaced by visible codes such as "\x1b".
std::string printable(std::string_view text);

}  // namespace pendular
