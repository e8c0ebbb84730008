#pragma once

#include <string>
#include <string_view>

#include "data/files/csv.h"

namespace pendular {

/// Way in which a file writes numbers.
struct NumberStyle {
    char decimal = '.';  ///< decimal mark, '.' or ','
    /// Whether numbers have to be rewritten before `parse_number` reads them: for a decimal comma
    /// and for thousands separators.
    bool rewrite = false;
};

/// Finds the decimal mark that all numbers of a file have in common, from cells in which only one
/// reading is possible: "1,25" and "0,125" have a decimal comma, "1,234,567" and "9,945.692" a
/// thousands separator.
class NumberStyleFinder {
  public:
    /// Takes note of the cells of a table.
    void look_at(const Table& table);

    /// Style of the numbers in the tables seen so far.
    /// @param decimal decimal mark that the user states; empty: to be found
    /// @throws InputError at the first cell in doubt, with both readings, if the cells leave the
    ///         mark open ("2,800" alone) or contradict one another
    NumberStyle style(const std::string& decimal) const;

  private:
    /// First cell that shows a way of writing numbers.
    struct Example {
        std::string text;
        Position at;
    };
    void look_at(const Table& table, const Row& row, std::size_t cell);

    Example point_, comma_;  ///< cells in which '.' or ',' must be the decimal mark
    Example grouped_;        ///< cells with thousands separators of any kind
    Example open_;           ///< cells such as "2,800", in which ',' may be either
};

/// Text of a number with a decimal point and without thousands separators; other texts unchanged.
std::string rewritten(const std::string& text, const NumberStyle& style);

/// Rewrites all numbers in the cells of a table (`rewritten`).
void rewrite_numbers(Table& table, const NumberStyle& style);

}  // namespace pendular
