#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "data/files/cell_formats.h"
#include "data/files/sheet_lines.h"

namespace pendular {

/// Name of a sheet, and whether the workbook hides it.
struct SheetName {
    std::string name;
    bool hidden = false;
};

/// @throws InputError always, with the reason why the file is no workbook that can be read
[[noreturn]] void refuse_workbook(const std::string& file, const std::string& reason);

/// Workbook of Excel 5 to 2003 (.xls): a compound file whose stream "Workbook" (or "Book", before
/// 1997) is a list of records. Cells read as those of newer workbooks (`rows_of_sheet`): with all
/// digits that are stored, dates by their formats, formulas by their results, errors as
/// "#DIV/0!". The file does not tell a formula whose result is an empty text from one that no
/// program has computed: where no formula of a sheet has a result, none was computed, and each
/// reads as "=".
/// Source: Microsoft, Excel Binary File Format, MS-XLS; for the versions before 1997, D. Rentz, The
/// Microsoft Excel File Format (2008).
class OldWorkbook {
  public:
    /// @param file path of the workbook, for error messages; must outlive the object
    /// @throws InputError if the bytes hold no such workbook, or one with a password
    OldWorkbook(const std::string& bytes, const std::string& file);
    OldWorkbook(const OldWorkbook&) = delete;  // it has views of itself
    OldWorkbook& operator=(const OldWorkbook&) = delete;

    /// Worksheets, without charts and macros, in the order of the workbook.
    const std::vector<SheetName>& sheets() const { return names_; }

    /// Work of reading a sheet alone, as the size of texts that would take as long [bytes]: the
    /// texts that all sheets share are read for it, and the records copied, which is some eight
    /// times as fast.
    std::size_t work_of_sheet() const { return shared_size_ + stream_.size() / 8; }

    /// @throws InputError for more than `most_cells` cells, and if another sheet begins within it
    SheetText rows(std::size_t sheet);

  private:
    void read_globals();
    void read_sheet(std::string_view record);
    /// @throws InputError if sheets begin at the same place, so that a short file would be as long
    ///         to read as it has sheets
    void find_ends();
    /// @param at place of the records that continue it
    void find_shared(std::string_view record, std::size_t at);
    /// Text that all sheets share, read when the first of them is needed; null if there is none.
    const std::string* shared_text(std::size_t index);
    /// Text at a place of a record, with its length before it in so many bytes.
    std::string text_at(std::string_view record, std::size_t at, std::size_t length_bytes) const;
    [[noreturn]] void refuse(const std::string& reason) const;

    const std::string& file_;
    std::string stream_;
    bool before_1997_ = false;  ///< texts are in a code page, not in Unicode
    std::string code_page_ = "windows-1252";
    bool from_1904_ = false;
    std::vector<SheetName> names_;
    std::vector<std::uint32_t> begins_;  ///< of the sheets in the stream
    std::vector<std::size_t> ends_;      ///< where the next of them begins, or the stream ends
    std::vector<std::vector<std::string_view>> shared_;  ///< records of texts that are not yet read
    std::size_t shared_size_ = 0;                        ///< of these [bytes]
    std::vector<std::string> strings_;                   ///< texts that all sheets share
    CellFormats formats_;
};

}  // namespace pendular
