#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace pendular {

// Texts of figures use the markup of gnuplot's enhanced text mode: "σ_{22}" has a subscript. Names,
// units and file names from a user must be escaped by `plain_text` or `broken_name` first.

/// Returns a text from a user, escaped for a figure, so that gnuplot shows the text as the user
/// wrote it and no character acts as markup. Control characters, including line ends, become
/// blanks.
std::string plain_text(const std::string& text);

/// Returns a text of a figure without the escapes that `plain_text` added. Markup that the program
/// wrote, such as "_{22}", is unchanged.
std::string unescaped(const std::string& text);

/// Returns the number of characters of a figure's text. Escapes that `plain_text` added do not
/// count. Markup such as "_{" counts.
std::size_t shown_characters(const std::string& text);

/// Breaks a name into short lines for the x axis of a figure, such as "capillary-", "shear-",
/// "stress", and escapes the lines as `plain_text` does. A line breaks at a line end, after a
/// hyphen if the line would otherwise exceed 10 characters, and inside a word of more than 24
/// characters.
std::vector<std::string> broken_name(const std::string& name);

/// Returns a text as a gnuplot string in double quotes, in which gnuplot neither executes a command
/// nor substitutes a variable. All characters except letters, blanks and characters beyond ASCII
/// are written as octal codes.
std::string gnuplot_string(const std::string& text);

}  // namespace pendular
