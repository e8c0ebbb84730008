#pragma once

#include <string>
#include <string_view>

#include "data/files/csv.h"

namespace pendular {

/// Style in which a file writes numbers.
struct NumberStyle {
    char decimal = '.';  ///< decimal mark of the file's numbers, '.' or ','
    /// Whether the file's numbers have a decimal comma or thousands separators, so that they must
    /// be rewritten before `parse_number` can read them.
    bool rewrite = false;
};

/// Determines the decimal mark that all numbers of a file have in common. Only unambiguous cells
/// count. The cells "1,25" and "0,125" have a decimal comma. The cells "1,234,567" and "9,945.692"
/// have thousands separators.
class NumberStyleFinder {
  public:
    /// Examines the numbers in the cells of a table, to determine their decimal mark.
    void look_at(const Table& table);

    /// Returns the style of the numbers in all tables examined so far.
    /// @param decimal decimal mark that the user states; empty: to be determined
    /// @throws InputError at the first ambiguous cell, such as "2,800", if no cell determines the
    ///         decimal mark; the message gives both interpretations
    /// @throws InputError at a cell that contradicts other cells or the stated mark
    NumberStyle style(const std::string& decimal) const;

  private:
    /// First cell of a file that contains a number in a given style, such as a decimal comma.
    struct Example {
        std::string text;
        Position at;
    };
    void look_at(const Table& table, const Row& row, std::size_t cell);

    /// First cell in which '.' must be the decimal mark (`point_`), and first cell in which ','
    /// must be the decimal mark (`comma_`).
    Example point_, comma_;
    Example grouped_;  ///< first cell of a number with thousands separators of any kind
    /// First cell with a number such as "2,800", in which ',' may be a decimal mark or a thousands
    /// separator.
    Example open_;
};

/// Returns the text of a number with a decimal point and without thousands separators. A text that
/// is no number in the given style is returned unchanged.
std::string rewritten(const std::string& text, const NumberStyle& style);

/// Rewrites all numbers in the cells of a table with a decimal point and without thousands
/// separators.
void rewrite_numbers(Table& table, const NumberStyle& style);

}  // namespace pendular
