#pragma once

#include <string>

namespace pendular {

/// Size of the text in figures, in hundredths of the inch of their page times 96/100: pixels of the
/// SVG, the format in which the text is largest. Titles are larger.
constexpr double text_size = 12, title_size = 13, dots_of_inch = 96;

/// Returns the width on the page [inch] of a text with markup, set in DejaVu Sans. Sub- and
/// superscripts have 0.8 of the size.
/// @param size of the text [1/96 inch]
double text_width(const std::string& text, double size = text_size);

}  // namespace pendular
