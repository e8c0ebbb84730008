#pragma once

#include <string>

namespace pendular {

/// Text for a page: "+-" becomes a plus-minus sign.
std::string page_text(std::string text);

}  // namespace pendular
