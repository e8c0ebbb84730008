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
    // No mark ends with a digit, as nearly all cells do.
    if (std::isdigit(static_cast<unsigned char>(cell.back()))) return false;
    if (cell.find_first_not_of("*-") == std::string_view::npos) return cell != "*";
    // In English, German ("keine Angabe", "nicht bestimmt"), French ("non
    // communiqué"), Spanish ("sin dato") and Italian ("non misurato"), of Excel, and as programs in
    // C print what is no number.
    constexpr std::array<std::string_view, 35> marks = {
        "nan",     "na",      "n/a",    "#n/a",      "#nv",     "null",  "none",   "n.d.",   "-nan",
        "n.a.",    "n. d.",   "k.a.",   "k. a.",     "n.b.",    "n. b.", "\u2013", "\u2014", "?",
        "1.#qnan", "-1.#ind", "1.#ind", "-nan(ind)", "missing", "fehlt", "err",    "error",  "#n/d",
        "s/d",     "s.d.",    "n.m.",   "s.o.",      "n.c.",    "n/d",   "n/m",    "n. m."};
    return cell.size() <= 9 && std::ranges::find(marks, in_small_letters(cell)) != marks.end();
}

}  // namespace pendular
