#pragma once

#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pendular {

/// Workbooks store dates and times of day as numbers of days, which only the format of the cell
/// tells from other numbers. Left as numbers, a column of clock times would be read as seconds that
/// are 86,400 times too short, and a torque that the spreadsheet took for a date (1.2 for the first
/// of February) as a number of days.
struct CellFormat {
    bool date = false;     ///< the format shows years, months or days
    bool time = false;     ///< the format shows hours, minutes or seconds
    bool percent = false;  ///< the format shows a hundred times the number, with "%"
};

/// Returns what a format code such as "[h]:mm:ss" or "0.00" shows.
CellFormat format_of_code(std::string_view code);

/// Returns what the format of an identifier that needs no code shows.
CellFormat format_of_identifier(unsigned identifier);

/// Formats of the cells of a workbook.
class CellFormats {
  public:
    CellFormats() = default;
    /// @param styles root of the part with the styles
    /// @param from_1904 whether dates count from 1904, as in workbooks of old Macintosh programs
    CellFormats(const pugi::xml_node& styles, bool from_1904);
    /// @param by_style formats by the index that cells state
    CellFormats(std::vector<CellFormat> by_style, bool from_1904)
        : by_style_(std::move(by_style)), from_1904_(from_1904) {}

    /// Returns the text of a number in a cell: "14:03:07.25" or "2024-03-01 14:03:07.25" for a time
    /// or date, and the number as it is stored otherwise. Hours of a format without a date count
    /// on above 24.
    /// @param style index that the cell states
    std::string text_of(std::string_view number, std::size_t style) const;
    /// Whether a cell shows a hundred times the number that it stores.
    /// @param style index that the cell states
    bool shows_percent(std::size_t style) const {
        return style < by_style_.size() && by_style_[style].percent;
    }

  private:
    std::vector<CellFormat> by_style_;
    bool from_1904_ = false;
};

}  // namespace pendular
