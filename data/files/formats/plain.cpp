#include <fmt/format.h>

#include <algorithm>

#include "data/files/column_names.h"
#include "data/files/columns.h"
#include "data/files/formats/layouts.h"
#include "data/files/formats/unit_cells.h"
#include "data/files/header_cell.h"
#include "data/files/header_names.h"
#include "data/files/missing_mark.h"
#include "data/quantities/number.h"
#include "data/quantities/quantity.h"

namespace pendular {
namespace {

/// Number of numbers in a cell that lists several, as in "990.5;1800.25"; 0 for other cells.
std::size_t listed_numbers(std::string_view text, char delimiter) {
    std::size_t count = 0;
    for (std::size_t begin = 0; begin <= text.size(); ++count) {
        const std::size_t end = std::min(text.find(delimiter, begin), text.size());
        if (!parse_number(text.substr(begin, end - begin))) return 0;
        begin = end + 1;
    }
    return count > 1 ? count : 0;
}

/// @throws InputError at the first cell that lists several numbers, if commas, which may be decimal
///         marks, do not separate the cells
void refuse_lists(const Table& table) {
    if (table.delimiter == ',') return;
    for (const Row& row : table.rows)
        for (std::size_t i = 0; i < row.cells.size(); ++i) {
            const std::string& text = row.cells[i].text;
            if (text.find(table.delimiter) == std::string::npos) continue;
            if (const std::size_t count = listed_numbers(text, table.delimiter))
                throw InputError(
                    table.at(row, i),
                    fmt::format("the cell holds a list of {} numbers, so this is a table of "
                                "results, not a recording; write one row for each number and "
                                "name the file in [[readings]]",
                                count));
        }
}

/// Replaces the header by the columns that the user states.
/// @throws InputError if their number is another
void state_columns(Table& table, const FileFormat& format) {
    if (format.columns.empty()) return;
    if (format.columns.size() != table.header.cells.size())
        throw InputError({table.file, table.header.line},
                         fmt::format("the header has {} columns, 'columns' states {}; state all",
                                     table.header.cells.size(), format.columns.size()));
    for (std::size_t i = 0; i < format.columns.size(); ++i)
        table.header.cells[i].text = format.columns[i];
}

/// Whether the numbers count the rows, as hours do: each is 1 more than the one before.
bool counts_up(const std::vector<double>& numbers) {
    for (std::size_t i = 1; i < numbers.size(); ++i)
        if (numbers[i] != numbers[i - 1] + 1) return false;
    return numbers.size() > 1;
}

/// Whether a column with a bare mark such as "SD" may hold errors. The mark has other meanings:
/// letters of a test, and hours in German.
bool may_hold_errors(const Table& table, std::size_t column) {
    std::vector<double> numbers;
    for (const Row& row : table.rows) {
        const std::string& text = row.cells[column].text;
        if (marks_no_value(text)) continue;
        // The decimal mark of the file is not known yet.
        std::string with_point = text;
        if (std::ranges::count(text, ',') == 1) std::ranges::replace(with_point, ',', '.');
        const auto number = parse_number(with_point);
        if (!number || *number < 0) return false;
        numbers.push_back(*number);
    }
    return !counts_up(numbers);
}

/// Gives columns with a bare mark that hold no errors the names back that they have in the file.
void take_back_marks(Table& table, const Row& written) {
    for (std::size_t i = 0; i < written.cells.size(); ++i) {
        const bool marked = bare_mark(parse_header_cell(written.cells[i].text)) != ErrorMark::none;
        if (marked && !may_hold_errors(table, i)) table.header.cells[i] = written.cells[i];
    }
}

/// Reads facts such as "# Inner radius: 21 mm" before the header.
void read_comments(const SourceLines& source, int header, BlockFile& file) {
    for (int line = 1; line < header; ++line) {
        std::string_view text = trimmed(source.lines[static_cast<std::size_t>(line) - 1]);
        const std::size_t colon = text.find_first_of(":=");
        if (!text.starts_with('#') || colon == std::string_view::npos) continue;
        file.add_fact({std::string(trimmed(text.substr(1, colon - 1))),
                       std::string(trimmed(text.substr(colon + 1))), line});
    }
}

}  // namespace

/// The program's own layout: one header of cells `name [unit]`, one row per sample.
Layout plain_layout() {
    return {"plain", "table with one header", [](const SourceLines&) { return true; },
            [](const SourceLines& source, const FileFormat& format, BlockFile& file) {
                Block block;
                int cut = 0;
                block.table = table_of(source.file, source.lines, &cut);
                if (cut > 0) skip_line(file, cut, Remark::Kind::cut_short);
                take_unit_row(block.table);
                state_columns(block.table, format);
                refuse_lists(block.table);
                const Row written = block.table.header;
                use_names_of_quantities(block.table.header);
                take_back_marks(block.table, written);
                for (std::size_t i = 0; i < written.cells.size(); ++i) {
                    const HeaderCell parts = parse_header_cell(written.cells[i].text);
                    const HeaderCell named = parse_header_cell(block.table.header.cells[i].text);
                    const Quantity* const quantity = quantity_of_cell(named.name, named.unit);
                    block.columns.push_back({parts.name, parts.unit,
                                             quantity ? std::string(quantity->name) : "",
                                             std::string(set_point_of(parts.name, parts.unit)),
                                             quantity && named.deviation()});
                }
                read_comments(source, block.table.header.line, file);
                file.delimiter = block.table.delimiter;
                file.blocks.push_back(std::move(block));
            }};
}

}  // namespace pendular
