#include <fmt/format.h>

#include "data/files/formats/layouts.h"
#include "data/files/formats/stacked_rows.h"

namespace pendular {

/// One line per quantity, or all quantities one after the other on one line: n times, then n
/// torques. Stated by study.toml, since no content shows it, or recognised by a single line of many
/// numbers.
Layout transposed_layout() {
    return {"transposed", "all values of a quantity on one line",
            [](const SourceLines& source) {
                const std::size_t first = first_filled_line(source, 0);
                if (first_filled_line(source, first + 1) < source.lines.size()) return false;
                char delimiter = ',';
                const Row row = headerless_first_row(source, delimiter);
                return row.cells.size() > 50 && all_numbers(row);
            },
            [](const SourceLines& source, const FileFormat& format, BlockFile& file) {
                headerless_first_row(source, file.delimiter);
                std::vector<Row> lines;
                for (std::size_t i = 0; i < source.lines.size(); ++i)
                    if (Row row = source.row(i, file.delimiter); !is_blank(row))
                        lines.push_back(std::move(row));
                if (lines.empty()) throw InputError({source.file}, "is empty");
                const std::size_t stated = format.columns.size();
                const std::size_t cells = lines[0].cells.size();
                const bool one_line = lines.size() == 1;
                if (stated == 0 || (one_line ? cells % stated != 0 : stated != lines.size()))
                    throw InputError(
                        {source.file, lines[0].line, 1},
                        fmt::format("has {} without names; state the quantities in their order in "
                                    "[[recording]], or of one file by --columns, like layout = "
                                    "\"transposed\" and columns = [\"Time "
                                    "[s]\", \"Torque [mN m]\"]",
                                    one_line ? fmt::format("{} numbers on one line", cells)
                                             : fmt::format("{} lines of numbers", lines.size())));
                const std::size_t count = one_line ? cells / stated : cells;
                const auto [names, units] = stated_columns(format);
                Block block;
                block.table.file = source.file;
                block.table.delimiter = file.delimiter;
                set_columns(file, block, stated_header(format, lines[0].line), names, units);
                for (std::size_t i = 0; i < count; ++i) {
                    Row row{lines[0].line, {}};
                    for (std::size_t k = 0; k < stated; ++k) {
                        const Row& line = one_line ? lines[0] : lines[k];
                        const std::size_t at = one_line ? k * count + i : i;
                        row.cells.push_back(at < line.cells.size() ? line.cells[at] : Cell{});
                    }
                    add_row(file, block, std::move(row));
                }
                file.blocks.push_back(std::move(block));
            }};
}

}  // namespace pendular
