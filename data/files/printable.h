#pragma once

#include <string>
#include <string_view>

namespace pendular {

/// Text that a terminal shows as it is, whatever file it came from: control characters other than
/// line ends and tabs, characters that change the direction of writing, and bytes that are not
/// UTF-8 become "\x1b" and the like.
std::string printable(std::string_view text);

}  // namespace pendular
