#pragma once

#include <string>

namespace pendular {

/// Marks between the cells of a text before `shape_text` rewrites it.
enum class TextShape { delimited, blanks, bars };

/// Rewrites a table whose text is of a form that the layouts do not read, with as many lines, and
/// with each number at its place in its line:
/// - cells between blanks, as numpy, MATLAB and LAMMPS write them, or between bars `|`: tabs divide
///   them
/// - names of the columns in the last comment above the numbers (`# time torque`): the comment sign
///   goes; `%` and `//` begin comments too
/// - the minus sign U+2212, and exponents of Fortran such as 1.5D-02
/// All other texts stay as they are.
TextShape shape_text(std::string& text);

}  // namespace pendular
