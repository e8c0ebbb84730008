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

/// Reads one of the tables that stand side by side: columns [begin, end), the first of which holds
/// `segment|point`.
void read_side(const SourceLines& source, std::size_t first, std::size_t begin, std::size_t end,
               int side, BlockFile& file) {
    const Row header = source.row(first, file.delimiter);
    const auto part = [&](const Row& row) {
        Row result{row.line, {}};
        for (std::size_t i = begin; i < std::min(end, row.cells.size()); ++i)
            result.cells.push_back({std::string(trimmed(row.cells[i].text)), row.cells[i].column});
        return result;
    };
    const Row own = part(header);
    std::vector<std::string> names, units;
    for (const Cell& cell : own.cells) {
        const HeaderCell parts = parse_header_cell(cell.text);
        names.push_back(parts.name);
        units.push_back(parts.unit);
    }
    for (std::size_t i = first + 1; i < source.lines.size(); ++i) {
        const Row row = part(source.row(i, file.delimiter));
        const int segment = row.cells.empty() ? 0 : segment_of(row.cells[0].text);
        if (segment == 0) {
            if (!is_blank(row))
                file.skipped.push_back({row.line, row.line, "without segment and point, as 2|15"});
            continue;
        }
        const std::string test = side == 0 ? "" : "table " + std::to_string(side);
        if (file.blocks.empty() || file.blocks.back().number != segment ||
            file.blocks.back().test != test) {
            Block block;
            block.test = test;
            block.number = segment;
            block.table.file = source.file;
            block.table.delimiter = file.delimiter;
            set_columns(block, own, names, units);
            file.blocks.push_back(std::move(block));
        }
        add_row(file.blocks.back(), row);
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
                const Row row = source.row(first + 1, file.delimiter);
                std::vector<std::size_t> begins;
                for (std::size_t i = 0; i < row.cells.size(); ++i)
                    if (segment_of(row.cells[i].text) > 0) begins.push_back(i);
                begins.push_back(row.cells.size());
                for (std::size_t k = 0; k + 1 < begins.size(); ++k)
                    read_side(source, first, begins[k], begins[k + 1],
                              begins.size() == 2 ? 0 : static_cast<int>(k) + 1, file);
            }};
}

}  // namespace pendular
