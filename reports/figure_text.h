#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace pendular {

// Texts of figures use the markup of gnuplot's enhanced text mode: "σ_{22}" has a subscript. Names,
// units and file names from a user must be escaped by `plain_text` or `broken_name` first.

/// Returns a text for a figure with escapes, so that gnuplot shows the text as it was written and
/// no character acts as markup. Control characters, line ends among them, become blanks.
std::string plain_text(const std::string& text);

/// Text of a figure without the escapes that `plain_text` added; the program's own markup stays.
std::string unescaped(const std::string& text);

/// Number of characters of a figure's text without the escapes of `plain_text`; markup such as "_{"
/// counts.
std::size_t shown_characters(const std::string& text);

/// Breaks a name into short lines below an x axis, escaped as by `plain_text`: "capillary-",
/// "shear-", "stress". Lines break at line ends, after hyphens where a line would become long, and
/// inside very long words.
std::vector<std::string> broken_name(const std::string& name);

/// Text as a gnuplot string in double quotes in which gnuplot executes and substitutes nothing: all
/// characters but letters, blanks and characters beyond ASCII are written as octal codes.
std::string gnuplot_string(const std::string& text);

}  // namespace pendular
