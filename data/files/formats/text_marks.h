#pragma once

#include <string>

namespace pendular {

/// Joins the lines of quoted cells among the first lines of a text: spreadsheets write a line break
/// within a header so. Empty lines after the joined one keep the numbers of the lines below.
void join_quoted_lines(std::string& text);

/// Writes minus signs and exponents as numbers have them elsewhere: '-' for U+2212, 'E' for the 'D'
/// of Fortran.
void unify_signs(std::string& text);

}  // namespace pendular
