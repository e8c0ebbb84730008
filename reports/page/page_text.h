#pragma once

#include <string>

namespace pendular {

/// Returns a text for an HTML page, with a plus-minus sign for each "+-".
std::string page_text(std::string text);

}  // namespace pendular
