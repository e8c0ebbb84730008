#include <algorithm>

#include "data/files/formats/layouts.h"
#include "data/files/header_cell.h"
#include "data/quantities/number.h"

namespace pendular {
namespace {

/// Number of the segment in a cell `segment|point`, as in "2|15"; 0 for other texts.
int segment_of(const std::string& text) {
    const std::size_t bar = text.find('|');
    if (bar == std::string::npos || !parse_number(text.substr(bar + 1))) return 0;
    return count_of(text.substr(0, bar));
}

/// Line of the header; the number of lines if no line with `segment|point` follows within 50 lines.
std::size_t rheowin_header(const SourceLines& source) {
    for (std::size_t i = 0; i + 1 < std::min<std::size_t>(source.lines.size(), 50); ++i) {
        const std::string_view next = source.lines[i + 1];
        const std::size_t end = next.find_first_of("\t;,");
        if (segment_of(std::string(trimmed(next.substr(0, end)))) == 1 &&
            source.lines[i].find(" in ") != std::string_view::npos)
            return i;
    }
    return source.lines.size();
}

/// Rows of a file from its header on that are not blank.
std::vector<Row> filled_rows(const SourceLines& source, std::size_t first, char delimiter) {
    std::vector<Row> rows;
    std::size_t cells = 0;
    for (std::size_t i = first; i < source.lines.size(); ++i) {
        Row row = source.row(i, delimiter);
        if (is_blank(row)) continue;
        check_cell_count(cells += row.cells.size(), source.file, row.line);
        rows.push_back(std::move(row));
    }
    return rows;
}

/// Reads one of the tables that stand side by side: columns [begin, end), the first of which holds
/// `segment|point`.
/// @param rows header and rows of all tables
void read_side(const std::vector<Row>& rows, std::size_t begin, std::size_t end, int side,
               BlockFile& file) {
    const auto part = [&](const Row& row) {
        Row result{row.line, {}};
        for (std::size_t i = begin; i < std::min(end, row.cells.size()); ++i)
            result.cells.push_back({std::string(trimmed(row.cells[i].text)), row.cells[i].column});
        return result;
    };
    const Row own = part(rows.front());
    std::vector<std::string> names, units;
    for (const Cell& cell : own.cells) {
        const HeaderCell parts = parse_header_cell(cell.text);
        names.push_back(parts.name);
        units.push_back(parts.unit);
    }
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const Row row = part(rows[i]);
        const int segment = row.cells.empty() ? 0 : segment_of(row.cells[0].text);
        if (segment == 0) {
            // Each table looks at all rows.
            check_cell_count(++file.counts.cells, file.file, row.line);
            if (!is_blank(row)) skip_line(file, row.line, Remark::Kind::without_segment);
            continue;
        }
        const std::string test = side == 0 ? "" : "table " + std::to_string(side);
        if (file.blocks.empty() || file.blocks.back().number != segment ||
            file.blocks.back().test != test) {
            Block block;
            block.test = test;
            block.number = segment;
            block.table.file = file.file;
            block.table.delimiter = file.delimiter;
            set_columns(file, block, own, names, units);
            file.blocks.push_back(std::move(block));
        }
        add_row(file, file.blocks.back(), row);
    }
}

}  // namespace

/// Export of Haake's RheoWin: header cells `name in unit`, rows that begin with `segment|point`,
/// and perhaps several such tables side by side.
Layout rheowin_layout() {
    return {"rheowin", "Thermo Fisher Haake RheoWin export",
            [](const SourceLines& source) { return rheowin_header(source) < source.lines.size(); },
            [](const SourceLines& source, const FileFormat&, BlockFile& file) {
                const std::size_t first = rheowin_header(source);
                if (first + 1 >= source.lines.size()) return;
                file.delimiter = consistent_delimiter(source, first, source.lines.size());
                const std::vector<Row> rows = filled_rows(source, first, file.delimiter);
                if (rows.size() < 2) return;
                const std::vector<Cell>& cells = rows[1].cells;
                std::vector<std::size_t> begins;
                for (std::size_t i = 0; i < cells.size(); ++i)
                    if (segment_of(cells[i].text) > 0) begins.push_back(i);
                begins.push_back(cells.size());
                for (std::size_t k = 0; k + 1 < begins.size(); ++k)
                    read_side(rows, begins[k], begins[k + 1],
                              begins.size() == 2 ? 0 : static_cast<int>(k) + 1, file);
            }};
}

}  // namespace pendular
