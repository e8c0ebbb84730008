#pragma once

#include <string>

namespace pendular {

/// Returns a text for an HTML page, with each "+-" replaced by a plus-minus sign.
std::string page_text(std::string text);

}  // namespace pendular
