#pragma once

#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "data/files/cell_formats.h"
#include "data/files/old_records.h"
#include "data/files/sheet_lines.h"

namespace pendular {

/// Returns the name of a code page of Windows, as ICU knows it; windows-1252 for unknown ones.
std::string code_page_name(unsigned number);

/// Returns a text in a code page as UTF-8, with a question mark in a diamond for bytes that are no
/// text in it: such a cell need not be one that is read.
std::string text_in_code_page(std::string_view bytes, const std::string& code_page);

/// Cells of a sheet of an old workbook, collected from its records.
class OldSheet {
  public:
    /// Returns the text at a place of a record, with its length before it in two bytes.
    using TextAt = std::function<std::string(std::string_view record, std::size_t at)>;

    /// Returns a text that all sheets share, which outlives the sheet; null if there is none.
    using SharedText = std::function<const std::string*(std::size_t index)>;

    /// The arguments must outlive the object.
    OldSheet(const std::string& file, const CellFormats& formats, TextAt text_at,
             SharedText shared_text)
        : file_(file),
          formats_(formats),
          text_at_(std::move(text_at)),
          shared_text_(std::move(shared_text)) {}

    /// Takes a record; those without cells are passed over.
    /// @throws InputError for more than `most_cells` cells
    void take(const OldRecord& record);
    /// Returns the rows of the sheet.
    SheetText text();

  private:
    struct Cell {
        CellPlace place;
        std::string text;
        /// Text that all sheets share, instead: one may be long and in many cells.
        const std::string* shared = nullptr;
        bool percent = false;  ///< whether it shows a hundred times the number

        const std::string& content() const { return shared ? *shared : text; }
    };

    void add(std::string_view record, std::string text);
    void add(Cell cell);
    void add_number(const CellPlace& place, unsigned style, double value);
    void take_formula(std::string_view record);
    void take_numbers(std::string_view record);
    void take_merged(std::string_view record);

    const std::string& file_;
    const CellFormats& formats_;
    TextAt text_at_;
    SharedText shared_text_;
    std::vector<Cell> cells_;
    std::set<std::size_t> hidden_;  ///< rows, from 0
    std::vector<std::pair<CellPlace, CellPlace>> merged_;
    std::vector<std::size_t> without_result_;  ///< cells with formulas
    bool awaits_text_ = false;                 ///< a formula's result is in a later record
    bool computed_ = false;                    ///< some formula has a result
};

}  // namespace pendular
