#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace pendular {

/// Fault that a check found in a file of measurements, with what the program does about the fault.
struct FileFinding {
    std::string file = {};  ///< path of the faulty file
    /// Ranges of the faulty lines of the file. Each pair is the first and the last line of a range,
    /// from 1.
    std::vector<std::pair<int, int>> lines = {};
    /// Name of the check that found the fault, such as "torque-shear_stress", "declared-rows" or
    /// "time".
    std::string kind = {};
    std::string what = {};  ///< sentence that says what is wrong with the file
    std::string done = {};  ///< sentence that says what the program does about the fault
};

/// Adds a line number to a list of ranges of lines. Each pair is the first and the last line of a
/// range. A line that directly follows the last range extends the range. Lines must be added in
/// ascending order.
void add_line(std::vector<std::pair<int, int>>& lines, int line);

/// Returns ranges of lines as text, such as "12-15, 20". Each pair is the first and the last line
/// of a range.
/// @param most maximum number of ranges in the text; if there are more ranges, the text ends with
///         the number of ranges left out
std::string text_of_lines(const std::vector<std::pair<int, int>>& lines, std::size_t most = 8);

/// Returns a finding as text with the faulty lines, with what is wrong and with what is done about
/// the fault, such as "Lines 12-15, 20: the time goes back. The rows are left out."
/// @param most maximum number of ranges of lines in the text
std::string text_of(const FileFinding& finding, std::size_t most = 8);

}  // namespace pendular
