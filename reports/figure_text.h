#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace pendular {

// The texts of figures are marked up as gnuplot's enhanced text: "σ_{22}" has a subscript. Names,
// units and files that a user wrote must go through `plain_text` or `broken_name` first.

/// A text that a figure shows as it was written: no character of it is markup. Control characters,
/// line ends among them, become blanks.
std::string plain_text(const std::string& text);

/// A text of a figure without what `plain_text` added; the program's own markup stays.
std::string unescaped(const std::string& text);

/// Number of characters that a text of a figure shows, its markup counted.
std::size_t shown_characters(const std::string& text);

/// A name as plain lines for an axis: "capillary-", "shear-", "stress". It is broken at its line
/// ends, behind hyphens where a line would become long, and anywhere in longer words.
std::vector<std::string> broken_name(const std::string& name);

/// A string in double quotes in which gnuplot finds nothing to execute or to substitute: all but
/// letters, blanks and characters beyond ASCII stand as octal codes.
std::string gnuplot_string(const std::string& text);

}  // namespace pendular
