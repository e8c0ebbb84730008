#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace pendular {

/// Returns the Damerau-Levenshtein distance of two words (optimal string alignment): number of
/// insertions, deletions, replacements and swaps of neighbouring bytes. Case is ignored.
int edit_distance(std::string_view first, std::string_view second);

/// Returns the known name with the smallest `edit_distance` from a misspelt word; empty if the
/// distance exceeds a third of the bytes of the word. One edit is always allowed.
std::optional<std::string> nearest(std::string_view word, std::span<const std::string> known);

/// Returns the end of an error message about an unknown word: "did you mean 'diameter'?", with the
/// name that `nearest` finds or the only known name that begins with the word, or else "known are
/// 'density', 'diameter'".
std::string did_you_mean(std::string_view word, std::span<const std::string> known);

}  // namespace pendular
