#pragma once

#include <string>

namespace pendular {

/// Joins the lines of quoted cells among the first lines of a text: spreadsheets write a line break
/// within a header so. Empty lines after the joined one keep the numbers of the lines below.
void join_quoted_lines(std::string& text);

/// Writes minus signs and exponents as numbers have them elsewhere: '-' for U+2212 and for a dash
/// before a number, 'E' for the 'D' of Fortran; blanks for no-break spaces that divide no
/// thousands, and "µ" for "Âµ".
void unify_signs(std::string& text);

/// Lets one tab stand for several where people align cells by them, so that columns need more tabs
/// behind short texts: all lines have as many cells with a text, but not as many tabs.
void join_tabs(std::string& text);

}  // namespace pendular
