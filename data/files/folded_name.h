#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace pendular {

/// Name of a column for comparison: in lower case, without accents on Latin letters, blanks, '_',
/// '-' and '.', so that "Hoehe", "HÖHE" and "Höhe", or "Velocita angolare" and "velocità_angolare",
/// are equal. The German "oe" counts as "ö", which becomes "o". Accents on other letters stay: "γ̇"
/// is a rate, "γ" a strain.
std::string folded_name(std::string_view name);

/// Whether a name, folded already, is one of a list of names.
template <class Names>
bool is_among_names(std::string_view folded, const Names& names) {
    return std::ranges::any_of(names,
                               [&](std::string_view each) { return folded_name(each) == folded; });
}

/// Text in lower case, with letters and accents together: "öl" for "ÖL", whichever way a system
/// writes them.
std::string lower_case(std::string_view text);

}  // namespace pendular
