#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "data/files/columns.h"
#include "data/files/formats/layouts.h"
#include "data/files/formats/stacked_rows.h"

namespace pendular {
namespace {

/// Columns of a tidy table before those of quantities.
constexpr std::size_t test_column = 0, interval_column = 1, role_column = 2;

bool is_tidy(const SourceLines& source) {
    return !source.lines.empty() && source.lines.front().starts_with(tidy_table_begin);
}

/// @throws InputError for a row that ends before its role, or whose role is none
void check_role(const std::string& file, const Row& row) {
    if (row.cells.size() <= role_column)
        throw InputError({file, row.line, row.cells.back().column},
                         "the row ends before its role; complete or remove this line");
    const Cell& role = row.cells[role_column];
    if (std::ranges::find(interval_roles(), role.text) == interval_roles().end())
        throw InputError({file, row.line, role.column},
                         fmt::format("'{}' is no role of an interval; known are '{}'", role.text,
                                     fmt::join(interval_roles(), "', '")));
}

/// Takes from the first row of an interval what all its rows say of the preshear.
void take_preshear(Block& block) {
    const Columns columns(block.table);
    const Row& row = block.table.rows.front();
    block.preshear_normal_stress = columns.value_if_any(row, "preshear_stress");
    block.preshear_shear_stress = columns.value_if_any(row, "preshear_shear_stress");
    block.bulk_density = columns.value_if_any(row, "bulk_density");
}

/// Begins the interval of a row.
Block block_of(const Row& row, const std::string& file) {
    Block block;
    block.test = row.cells[test_column].text;
    block.number = count_of(row.cells[interval_column].text);
    block.stated_role = row.cells[role_column].text;
    block.table.file = file;
    block.table.delimiter = ',';
    return block;
}

void read_tidy(const SourceLines& source, const FileFormat&, BlockFile& file) {
    if (!is_tidy(source))
        throw InputError({source.file, 1}, fmt::format("the first line of the layout tidy begins "
                                                       "with {}",
                                                       tidy_table_begin));
    file.delimiter = ',';
    const Row names = source.row(0, ','),
              units = source.row(std::min<std::size_t>(1, source.lines.size() - 1), ',');
    std::vector<std::string> name_texts, unit_texts;
    for (std::size_t i = 0; i < names.cells.size(); ++i) {
        // The first four are read here, or not at all.
        name_texts.push_back(names.cells[i].text);
        unit_texts.push_back(i < units.cells.size() && i > role_column ? units.cells[i].text : "");
    }
    std::string before;
    for (std::size_t i = 2; i < source.lines.size(); ++i) {
        Row row = source.row(i, ',');
        if (is_blank(row)) continue;
        check_role(source.file, row);
        std::string now;
        for (const std::size_t each : {test_column, interval_column, role_column})
            now += row.cells[each].text + '\n';
        if (file.blocks.empty() || now != before) {
            Block block = block_of(row, source.file);
            set_columns(file, block, names, name_texts, unit_texts);
            // A name that is no quantity's: the block has the number, and the cells are cleared.
            block.table.header.cells[interval_column].text = "number of the interval";
            file.blocks.push_back(std::move(block));
        }
        before = now;
        for (const std::size_t each : {test_column, interval_column, role_column})
            row.cells[each].text.clear();
        add_row(file, file.blocks.back(), std::move(row));
    }
    std::ranges::for_each(file.blocks, take_preshear);
}

}  // namespace

/// Table that `import FILE --tidy` writes: test, number and role of the interval, line of the file
/// and quantities in SI units, with a row of units.
Layout tidy_layout() {
    return {"tidy", "table that --tidy wrote", is_tidy, read_tidy};
}

}  // namespace pendular
