#include "data/files/missing_mark.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace pendular {

std::string in_small_letters(std::string_view text) {
    std::string lower(text);
    for (char& c : lower)
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return lower;
}

bool marks_no_value(std::string_view cell) {
    if (cell.empty()) return true;
    if (cell.size() >= 2 && cell.find_first_not_of("*-") == std::string_view::npos) return true;
    constexpr std::array<std::string_view, 9> marks = {"nan",  "na",   "n/a",  "#n/a", "#nv",
                                                       "null", "none", "n.d.", "-nan"};
    return cell.size() <= 4 && std::ranges::find(marks, in_small_letters(cell)) != marks.end();
}

}  // namespace pendular
