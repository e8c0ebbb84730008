#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace pendular {

/// Result of a check of a file: what is wrong with some of its lines, and what was done about it.
struct FileFinding {
    std::string file = {};                        ///< path of the file
    std::vector<std::pair<int, int>> lines = {};  ///< first and last line of each range of lines
    std::string kind = {};  ///< "torque-stress", "declared-rows", "time" and so on
    std::string what = {};  ///< sentence on what is wrong
    std::string done = {};  ///< sentence on what the program does about it
};

/// Adds a line to ranges of lines in rising order.
void add_line(std::vector<std::pair<int, int>>& lines, int line);

/// Ranges of lines as a text: "12-15, 20". At most `most` ranges are named; the number of the
/// others follows.
std::string text_of_lines(const std::vector<std::pair<int, int>>& lines, std::size_t most = 8);

/// A finding as a text: its lines, what is wrong, and what is done about it, as in "Lines 12-15,
/// 20: the time goes back. The rows are left out.". At most `most` ranges of lines are named.
std::string text_of(const FileFinding& finding, std::size_t most = 8);

}  // namespace pendular
