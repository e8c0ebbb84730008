#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pendular {

/// Largest total size of the parts of a workbook that are read, unpacked, and of the text of a
/// sheet [bytes]: as `largest_table`, since a small archive may unpack to any size, and a short
/// sheet may have one long text in any number of cells.
constexpr std::uintmax_t largest_unpacked = 256u << 20;

/// Number in a cell that is merged over several columns, so that it is not known where it belongs.
struct WideNumber {
    int line = 0;                           ///< from 1
    int first_column = 0, last_column = 0;  ///< from 1
    std::string text;
};

/// Place of a cell, from 0.
struct CellPlace {
    std::size_t row = 0, column = 0;
    auto operator<=>(const CellPlace&) const = default;
};

/// Rows of a sheet of a workbook as text.
struct SheetText {
    /// One line per row, with cells separated by tabs. Each row with values has as many cells as
    /// the widest row, and each row without values is an empty line.
    std::string text;
    /// First and last lines, from 1, of rows with values that the spreadsheet hides.
    std::vector<std::pair<int, int>> hidden;
    std::vector<WideNumber> wide;  ///< in the order of the lines; the first of its cells has it
    /// Cells, in their order, that show a hundred times the number that stands in the text.
    std::vector<CellPlace> percents;
};

/// Writes the rows of a sheet as lines, from the first to the last. A number in a merged cell of
/// one column stands in each of its rows. Tabs and line ends within a cell become blanks.
class SheetLines {
  public:
    /// @param file path of the sheet, for error messages; must outlive the object
    /// @param width number of cells of each row
    SheetLines(const std::string& file, std::size_t width) : file_(file), cells_(width) {}

    void merge(const CellPlace& first, const CellPlace& last) { merged_[first] = last; }

    /// Number of lines so far: index of the next row.
    std::size_t lines() const { return lines_; }
    /// Number of the next line, from 1.
    int line() const { return static_cast<int>(lines_) + 1; }

    /// Adds empty lines until there are `lines`.
    void add_empty_until(std::size_t lines);

    /// Begins a row with values.
    /// @throws InputError for more than `most_cells` cells so far
    void begin_row(bool hidden);
    /// @param column from 0, below the width
    /// @param percent whether the cell shows a hundred times the number that it stores
    /// @throws InputError for more than `largest_unpacked` of text so far
    void set(std::size_t column, std::string text, bool percent = false);
    /// @throws InputError as `set`, for numbers in merged cells
    void end_row();

    SheetText take() { return std::move(result_); }

  private:
    /// Text that stands in the rows up to `last`.
    struct Held {
        std::string text;
        std::size_t last;
        bool percent;
    };

    void hold(std::size_t column);
    void add_line();
    /// Counts text that a cell is to have.
    void count(const std::string& text);

    const std::string& file_;
    SheetText result_;
    std::size_t lines_ = 0, cell_count_ = 0;
    std::uintmax_t text_size_ = 0;           ///< of the cells so far [bytes]
    std::vector<std::string> cells_;         ///< of the present row
    std::set<std::size_t> percents_;         ///< columns of the present row that show per cent
    std::map<CellPlace, CellPlace> merged_;  ///< last place of merged cells, by the first
    std::map<std::size_t, Held> held_;       ///< by column
};

}  // namespace pendular
