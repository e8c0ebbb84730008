#pragma once

#include <string>
#include <string_view>

#include "data/files/csv.h"

namespace pendular {

/// Style in which a file writes numbers.
struct NumberStyle {
    char decimal = '.';  ///< decimal mark, '.' or ','
    /// Whether a decimal comma or thousands separators must be rewritten for `parse_number`.
    bool rewrite = false;
};

/// Determines the decimal mark that all numbers of a file have in common. Only unambiguous cells
/// count. The cells "1,25" and "0,125" have a decimal comma. The cells "1,234,567" and "9,945.692"
/// have thousands separators.
class NumberStyleFinder {
  public:
    /// @param points_are_decimal whether a point is known to be no thousands separator
    explicit NumberStyleFinder(bool points_are_decimal = false)
        : points_are_decimal_(points_are_decimal) {}

    void look_at(const Table& table);
    /// Looks at one cell of a row.
    void look_at(const Table& table, const Row& row, std::size_t cell);

    /// Returns the style of the numbers in all tables looked at so far.
    /// @param decimal decimal mark that the user states; empty: to be determined
    /// @throws InputError at the first cell such as "2,800" or "2.800" if no cell determines the
    ///         decimal mark, and at a cell that contradicts other cells or
    ///         the stated mark
    NumberStyle style(const std::string& decimal) const;

  private:
    /// First cell of a kind.
    struct Example {
        std::string text;
        Position at;
    };
    [[noreturn]] static void refuse_open(const Example& open, char mark, const Example& other);

    Example point_, comma_;  ///< in which '.', or ',', must be the decimal mark
    Example grouped_;        ///< with thousands separators of any kind
    Example open_;           ///< such as "2,800", where ',' may be either
    Example open_point_;     ///< such as "2.800", where '.' may be either
    bool points_are_decimal_;
};

/// Whether the point in a number may separate thousands, as in "2.800".
bool point_may_group(std::string_view text);

/// Returns the text of a number with a decimal point and without thousands separators; unchanged if
/// it is no number in the given style.
std::string rewritten(const std::string& text, const NumberStyle& style);

/// Applies `rewritten` to all cells below the header, if `style.rewrite`.
void rewrite_numbers(Table& table, const NumberStyle& style);

}  // namespace pendular
