#include "reports/page/page_text.h"

#include <cstddef>

namespace pendular {

std::string page_text(std::string text) {
    for (std::size_t at = 0; (at = text.find("+-", at)) != std::string::npos;) {
        text.replace(at, 2, "±");
    }
    return text;
}

}  // namespace pendular
