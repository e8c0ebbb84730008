#include <algorithm>

#include "data/files/formats/layouts.h"

namespace pendular {
namespace {

/// Index of the first line that reads `[step]`; the number of lines if there is none.
std::size_t first_trios_step(const SourceLines& source) {
    return static_cast<std::size_t>(
        std::ranges::find_if(source.lines,
                             [](std::string_view line) { return line.starts_with("[step]"); }) -
        source.lines.begin());
}

/// Reads the keys and values before the first step.
void read_trios_facts(const SourceLines& source, std::size_t end, BlockFile& file) {
    for (std::size_t i = 0; i < end; ++i) {
        const Row row = source.row(i, file.delimiter);
        if (row.cells.size() < 2 || row.cells[0].text.empty()) continue;
        std::string value = row.cells[1].text;
        // A value may contain the delimiter.
        for (std::size_t k = 2; k < row.cells.size(); ++k)
            value += file.delimiter + row.cells[k].text;
        file.add_fact({row.cells[0].text, value, row.line});
    }
}

/// Reads a step, from the line after `[step]` on. Returns the line after it.
std::size_t read_trios_step(const SourceLines& source, std::size_t line, BlockFile& file) {
    Block block;
    block.number = static_cast<int>(file.blocks.size()) + 1;
    block.table.file = source.file;
    block.table.delimiter = file.delimiter;
    if (line + 2 >= source.lines.size())
        throw InputError({source.file, static_cast<int>(line)},
                         "names and units of the columns must follow '[step]'; the file was cut "
                         "off: export it again");
    std::string_view name = source.lines[line];  // a sheet of a workbook has empty cells behind it
    name = name.substr(0, name.find_last_not_of(" \t;,") + 1);
    block.name = std::string(name);
    const Row header = source.row(line + 1, file.delimiter);
    std::vector<std::string> names, units;
    for (const Cell& cell : header.cells)
        names.push_back(cell.text);
    for (const Cell& cell : source.row(line + 2, file.delimiter).cells)
        units.push_back(cell.text);
    set_columns(file, block, header, names, units);
    for (line += 3; line < source.lines.size(); ++line) {
        if (source.lines[line].starts_with('[')) break;
        const Row row = source.row(line, file.delimiter);
        if (!is_blank(row)) add_row(file, block, row);
    }
    file.blocks.push_back(std::move(block));
    return line;
}

}  // namespace

/// Export of TA Instruments' TRIOS as CSV, text or for LIMS: sections of keys and values, then for
/// each step a line `[step]`, the step's name, names and units of the columns, and values.
Layout trios_layout() {
    return {
        "trios", "TA Instruments TRIOS export",
        [](const SourceLines& source) { return first_trios_step(source) < source.lines.size(); },
        [](const SourceLines& source, const FileFormat&, BlockFile& file) {
            std::size_t line = first_trios_step(source);
            file.delimiter = consistent_delimiter(source, line + 2, source.lines.size());
            read_trios_facts(source, line, file);
            while (line < source.lines.size())
                line = source.lines[line].starts_with("[step]")
                           ? read_trios_step(source, line + 1, file)
                           : line + 1;
        }};
}

}  // namespace pendular
