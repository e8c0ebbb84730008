#include "data/files/formats/named_columns.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

#include "data/files/column_names.h"

namespace pendular {
namespace {

std::string with_unit_of_file(const BlockColumn& column) {
    return column.unit.empty() ? column.name : fmt::format("{} [{}]", column.name, column.unit);
}

/// Index of the column that a text means: with its unit or, if the text has the right one where the
/// file has none or a wrong one, by its name.
std::optional<std::size_t> column_meant(const Block& block, const std::string& text) {
    const HeaderCell wanted = parse_header_cell(text);
    std::optional<std::size_t> by_name;
    for (std::size_t i = 0; i < block.columns.size(); ++i) {
        const BlockColumn& column = block.columns[i];
        if (column.name != wanted.name && column.name != text) continue;
        if (wanted.unit.empty() || column.unit == wanted.unit) return i;
        if (!by_name) by_name = i;
    }
    return by_name;
}

void name_column(Block& block, const std::string& quantity, std::size_t index,
                 const std::string& text) {
    const HeaderCell wanted = parse_header_cell(text);
    for (std::size_t i = 0; i < block.columns.size(); ++i) {
        BlockColumn& column = block.columns[i];
        if (i == index || column.quantity != quantity) continue;
        column.quantity.clear();
        block.table.header.cells[i].text = fmt::format("{}, column {}", column.name, i + 1);
    }
    BlockColumn& column = block.columns[index];
    column.quantity = quantity;
    if (!wanted.unit.empty() && wanted.name == column.name) column.unit = wanted.unit;
    block.table.header.cells[index].text =
        column.unit.empty() ? quantity : fmt::format("{} [{}]", quantity, column.unit);
}

}  // namespace

void use_named_columns(BlockFile& file, const FileFormat& format) {
    for (const auto& [quantity, text] : format.named_columns) {
        bool found = false;
        for (Block& block : file.blocks) {
            const auto index = column_meant(block, text);
            if (!index) continue;
            name_column(block, quantity, *index, text);
            found = true;
        }
        if (found || file.blocks.empty()) continue;
        std::vector<std::string> names;
        for (const BlockColumn& column : file.blocks.front().columns)
            if (!column.name.empty()) names.push_back(with_unit_of_file(column));
        throw InputError({file.file, file.blocks.front().table.header.line},
                         fmt::format("no column is called '{}', as 'columns' states for '{}'; the "
                                     "columns are '{}'",
                                     text, quantity, fmt::join(names, "', '")));
    }
}

std::string line_to_name(std::string_view quantity, std::string_view name, std::string_view unit) {
    return fmt::format("columns = {{ {} = \"{} [{}]\" }}", quantity, name, unit);
}

}  // namespace pendular
