#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace pendular {

/// Fault that a check found in a file of measurements.
struct FileFinding {
    std::string file = {};
    std::vector<std::pair<int, int>> lines = {};  ///< first and last line of each range, from 1
    std::string kind = {};  ///< name of the check, such as "torque-shear_stress" or "time"
    std::string what = {};  ///< sentence on what is wrong
    std::string done = {};  ///< sentence on what the program does about it
};

/// Adds a line to the last range if it follows directly, and otherwise as a new one. Lines must be
/// added in ascending order.
void add_line(std::vector<std::pair<int, int>>& lines, int line);

/// Returns ranges of lines as text, such as "12-15, 20", with at most `most` ranges and the number
/// of those left out.
std::string text_of_lines(const std::vector<std::pair<int, int>>& lines, std::size_t most = 8);

/// Returns a finding as text with at most `most` ranges of lines, such as "Lines 12-15, 20: the
/// time goes back. The rows are left out."
std::string text_of(const FileFinding& finding, std::size_t most = 8);

}  // namespace pendular
