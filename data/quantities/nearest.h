#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace pendular {

/// Number of single-character edits (insertions, deletions, replacements, swaps of neighbours) that
/// turn one word into another, regardless of case.
/// Source: Damerau-Levenshtein distance, optimal string alignment.
int edit_distance(std::string_view first, std::string_view second);

/// Known name with the fewest edits (`edit_distance`) from a misspelt word. Empty if every name
/// needs more edits than one and than a third of the word's length in bytes.
std::optional<std::string> nearest(std::string_view word, std::span<const std::string> known);

/// Hint to end an error message about an unknown word: "did you mean 'diameter'?" or, if no known
/// name is near, "known are 'density', 'diameter'".
std::string did_you_mean(std::string_view word, std::span<const std::string> known);

}  // namespace pendular
