#include <fmt/format.h>

#include <algorithm>

#include "data/files/column_names.h"
#include "data/files/formats/clock_times.h"
#include "data/files/formats/layouts.h"
#include "data/files/formats/stacked_rows.h"
#include "data/files/formats/unit_cells.h"
#include "data/files/header_cell.h"
#include "data/files/missing_mark.h"
#include "data/quantities/number.h"

namespace pendular {
namespace {

/// Index of the line of units below the names of the line `header`; the number of lines if there is
/// none. Up to two lines of remarks, such as "Waveform", may stand between.
std::size_t line_of_units(const SourceLines& source, std::size_t header, char delimiter) {
    std::size_t line = header;
    const Row names = source.row(header, delimiter);
    for (int between = 0; between < 3; ++between) {
        line = first_filled_line(source, line + 1);
        if (line >= source.lines.size()) break;
        const Row row = source.row(line, delimiter);
        if (is_unit_row(names, row)) return line;
        const bool numbers =
            std::ranges::any_of(row.cells, [](const Cell& cell) { return is_number(cell.text); });
        if (numbers) break;
    }
    return source.lines.size();
}

bool is_unit_row_table(const SourceLines& source) {
    const std::size_t header = first_filled_line(source, 0);
    const std::size_t next = first_filled_line(source, header + 1);
    if (next >= source.lines.size()) return false;
    const char delimiter = consistent_delimiter(source, next, source.lines.size());
    const Row names = source.row(header, delimiter);
    return counts_points(names.cells[0].text) ||
           line_of_units(source, header, delimiter) < source.lines.size();
}

/// A line such as `Point [1]`, `Time [s]` that a user may paste to state units. Units that the file
/// states are kept.
std::string suggested_columns(const NamesAndUnits& columns) {
    std::vector<std::string> cells;
    for (std::size_t i = 0; i < columns.names.size(); ++i) {
        const std::string& name = columns.names[i];
        if (!columns.units[i].empty()) {
            cells.push_back(fmt::format("\"{} [{}]\"", name, columns.units[i]));
            continue;
        }
        const std::string_view quantity = meaning_of_column(name, "").quantity;
        cells.push_back(
            fmt::format("\"{} [{}]\"", name, quantity.empty() ? "1" : usual_unit(quantity)));
    }
    return fmt::format("columns = [{}]", fmt::join(cells, ", "));
}

/// Names and units in the header cells, such as "Torque [mN m]".
NamesAndUnits columns_of(const Row& header) {
    NamesAndUnits columns;
    for (const Cell& cell : header.cells) {
        const HeaderCell parts = parse_header_cell(cell.text);
        // Only where the cell states a unit is the end of its text no part of the name, such as
        // "Time (sequence)".
        const bool stated = !parts.unit.empty() && is_unit(parts.unit);
        columns.names.push_back(stated ? parts.name : cell.text);
        columns.units.push_back(stated ? parts.unit : "");
    }
    return columns;
}

/// Names in the header cells with the units of a row below.
NamesAndUnits columns_of(const Row& header, const Row& units) {
    NamesAndUnits columns;
    for (const Cell& cell : header.cells)
        columns.names.push_back(cell.text);
    for (const Cell& cell : units.cells)
        columns.units.push_back(says_units(cell) ? "" : bare_unit(cell.text));
    return columns;
}

/// Whether a column that names a quantity has no unit, which clock times do not need.
/// @param row first one below the names
bool lacks_unit(const NamesAndUnits& columns, const Row& row) {
    for (std::size_t i = 0; i < columns.names.size(); ++i)
        if (columns.units[i].empty() && !counts_points(columns.names[i]) &&
            !(i < row.cells.size() && clock_time(row.cells[i].text)) &&
            !meaning_of_column(columns.names[i], "").quantity.empty())
            return true;
    return std::ranges::all_of(columns.units, &std::string::empty);
}

/// Index of the line after the units from which on rows are read: lines of remarks without a
/// number, such as the comments of Origin, are passed over.
std::size_t first_row_below(const SourceLines& source, std::size_t line, char delimiter) {
    constexpr int most_remarks = 3;
    for (int remarks = 0; remarks < most_remarks; ++remarks) {
        const std::size_t filled = first_filled_line(source, line);
        if (filled >= source.lines.size()) break;
        const Row row = source.row(filled, delimiter);
        const bool texts = std::ranges::all_of(row.cells, [](const Cell& cell) {
            return cell.text.empty() || (!marks_no_value(cell.text) && !parse_number(cell.text) &&
                                         !has_decimal_comma(cell.text) && !clock_time(cell.text));
        });
        if (!texts) break;
        line = filled + 1;
    }
    return line;
}

void read_unit_row_table(const SourceLines& source, const FileFormat& format, BlockFile& file) {
    const std::size_t first = first_filled_line(source, 0);
    if (first == source.lines.size()) throw InputError({source.file}, "is empty");
    std::size_t next = first_filled_line(source, first + 1);
    file.delimiter = consistent_delimiter(source, next, source.lines.size());
    const Row header = source.row(first, file.delimiter);
    const std::size_t units = line_of_units(source, first, file.delimiter);
    const bool has_units = units < source.lines.size();
    NamesAndUnits columns =
        has_units ? columns_of(header, source.row(units, file.delimiter)) : columns_of(header);
    if (has_units) next = first_row_below(source, units + 1, file.delimiter);
    if (!format.columns.empty()) {
        if (format.columns.size() != columns.names.size())
            throw InputError(
                {source.file, header.line},
                fmt::format("the header has {} columns, 'columns' states {}; state all",
                            columns.names.size(), format.columns.size()));
        columns = stated_columns(format);
    } else if (!has_units &&
               lacks_unit(columns,
                          next < source.lines.size() ? source.row(next, file.delimiter) : Row{})) {
        const bool none = std::ranges::all_of(columns.units, &std::string::empty);
        throw InputError(
            {source.file, header.line},
            fmt::format("has names {}; state them in [[recording]], or for "
                        "one file by --columns, "
                        "corrected where these guesses are wrong: {}",
                        none ? "but no units" : "without units", suggested_columns(columns)));
    }
    read_stacked_rows(source, next, header, columns, file);
}

}  // namespace

/// Table with a row of names and a row of units in brackets, whose intervals are stacked: cells of
/// a RheoCompass table that were copied to a spreadsheet, for example.
Layout unit_row_layout() {
    return {"unit-row", "table with a row of units, intervals stacked", is_unit_row_table,
            read_unit_row_table};
}

}  // namespace pendular
