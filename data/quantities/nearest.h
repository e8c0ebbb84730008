#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace pendular {

/// Returns the number of single-character edits (insertions, deletions, replacements, swaps of
/// neighbours) that turn the first word into the second word. Upper and lower case count as equal.
/// Source: Damerau-Levenshtein distance, optimal string alignment.
int edit_distance(std::string_view first, std::string_view second);

/// Returns the known name that differs from a misspelt word by the fewest edits (`edit_distance`).
/// The number of edits must not exceed a third of the number of bytes of the word; one edit is
/// always allowed. The result is empty if every known name differs by more edits.
std::optional<std::string> nearest(std::string_view word, std::span<const std::string> known);

/// Returns a hint for the end of an error message about an unknown word, such as "did you mean
/// 'diameter'?". The hint states the name that `nearest` finds, or the only known name that begins
/// with the word. If there is neither, the hint lists all known names: "known are 'density',
/// 'diameter'".
std::string did_you_mean(std::string_view word, std::span<const std::string> known);

}  // namespace pendular
