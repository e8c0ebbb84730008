#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace pendular {

/// Number of single-character edits (insert, delete, replace, swap neighbours) between two words,
/// regardless of case.
/// Source: Damerau-Levenshtein distance, optimal string alignment.
int edit_distance(std::string_view first, std::string_view second);

/// Known name that a misspelt word most likely means: the nearest one, if no more than a third of
/// the word has to change; else empty.
std::optional<std::string> nearest(std::string_view word, std::span<const std::string> known);

/// The end of an error about an unknown word: "did you mean 'diameter'?", or, where nothing is
/// near, "known are 'density', 'diameter'".
std::string did_you_mean(std::string_view word, std::span<const std::string> known);

}  // namespace pendular
