#include <algorithm>

#include "data/files/formats/layouts.h"
#include "data/files/header_cell.h"

namespace pendular {
namespace {

/// Delimiter behind the first header cell, "Action Name"; 0 if the file does not begin with it.
char rspace_delimiter(const SourceLines& source) {
    constexpr std::string_view first = "Action Name";
    if (source.lines.empty() || !source.lines[0].starts_with(first)) return 0;
    const std::string_view rest = source.lines[0].substr(first.size());
    return rest.empty() ? '\0' : rest[0];
}

}  // namespace

/// Export of Malvern's rSpace: one header with units in parentheses, whose first column names the
/// action; a change of the action begins a block.
Layout rspace_layout() {
    return {"rspace", "Malvern rSpace export",
            [](const SourceLines& source) { return rspace_delimiter(source) != 0; },
            [](const SourceLines& source, const FileFormat&, BlockFile& file) {
                file.delimiter = rspace_delimiter(source);
                if (file.delimiter == 0) return;
                const Row header = source.row(0, file.delimiter);
                std::vector<std::string> names, units;
                for (const Cell& cell : header.cells) {
                    const HeaderCell parts = parse_header_cell(cell.text);
                    names.push_back(parts.name);
                    units.push_back(parts.unit);
                }
                for (std::size_t i = 1; i < source.lines.size(); ++i) {
                    const Row row = source.row(i, file.delimiter);
                    if (is_blank(row)) continue;
                    const std::string& action = row.cells[0].text;
                    if (file.blocks.empty() || file.blocks.back().name != action) {
                        Block block;
                        block.name = action;
                        block.number = static_cast<int>(file.blocks.size()) + 1;
                        block.table.file = source.file;
                        block.table.delimiter = file.delimiter;
                        set_columns(file, block, header, names, units);
                        file.blocks.push_back(std::move(block));
                    }
                    add_row(file, file.blocks.back(), row);
                }
            }};
}

}  // namespace pendular
