#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace pendular {

// Texts of figures use the markup of gnuplot's enhanced text mode: "σ_{22}" has a subscript. Names,
// units and file names from a user must be escaped by `plain_text` or `broken_name` first.

/// Returns a text escaped for a figure, so that gnuplot shows it as the user wrote it. Control
/// characters, including line ends, become blanks.
std::string plain_text(const std::string& text);

/// Returns a text without the escapes of `plain_text`; markup such as "_{22}" stays.
std::string unescaped(const std::string& text);

/// Returns the number of characters without the escapes of `plain_text`. Markup counts.
std::size_t shown_characters(const std::string& text);

/// Breaks a name into short, escaped lines for an x axis: "capillary-", "shear-", "stress". Lines
/// end at line ends, after a hyphen if the line would exceed 10 characters, and inside a word of
/// more than 24 characters.
std::vector<std::string> broken_name(const std::string& name);

/// Returns a gnuplot string in double quotes in which gnuplot neither executes a command nor
/// substitutes a variable: all but letters, blanks and characters beyond ASCII are octal codes.
std::string gnuplot_string(const std::string& text);

}  // namespace pendular
