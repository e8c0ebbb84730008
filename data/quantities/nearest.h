#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace pendular {

/// Number of single-character edits (insertions, deletions, replacements, swaps of neighbours) that
/// turn the first word into the second. Upper and lower case count as equal.
/// Source: Damerau-Levenshtein distance, optimal string alignment.
int edit_distance(std::string_view first, std::string_view second);

/// Returns the known name that differs from a misspelt word by the fewest edits (`edit_distance`).
/// Empty if every name needs more edits than a third of the length of the word in bytes, at least
/// one edit being allowed.
std::optional<std::string> nearest(std::string_view word, std::span<const std::string> known);

/// Returns a hint for the end of an error message about an unknown word: "did you mean 'diameter'?"
/// or, if no known name is similar, "known are 'density', 'diameter'".
std::string did_you_mean(std::string_view word, std::span<const std::string> known);

}  // namespace pendular
