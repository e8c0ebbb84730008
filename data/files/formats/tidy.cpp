#include <algorithm>

#include "data/files/formats/layouts.h"
#include "data/files/formats/stacked_rows.h"

namespace pendular {
namespace {

/// Columns of a tidy table before those of quantities.
constexpr std::size_t test_at = 0, interval_at = 1, role_at = 2;

bool is_tidy(const SourceLines& source) {
    return !source.lines.empty() && source.lines.front().starts_with(tidy_table_begin);
}

void read_tidy(const SourceLines& source, const FileFormat&, BlockFile& file) {
    file.delimiter = ',';
    const Row names = source.row(0, ','),
              units = source.row(std::min<std::size_t>(1, source.lines.size() - 1), ',');
    std::vector<std::string> name_texts, unit_texts;
    for (std::size_t i = 0; i < names.cells.size(); ++i) {
        // The first four are read here, or not at all.
        name_texts.push_back(names.cells[i].text);
        unit_texts.push_back(i < units.cells.size() && i > role_at ? units.cells[i].text : "");
    }
    std::string before;
    for (std::size_t i = 2; i < source.lines.size(); ++i) {
        Row row = source.row(i, ',');
        if (is_blank(row) || row.cells.size() <= role_at) continue;
        const std::string now = row.cells[test_at].text + '\n' + row.cells[interval_at].text +
                                '\n' + row.cells[role_at].text;
        if (file.blocks.empty() || now != before) {
            Block block;
            block.test = row.cells[test_at].text;
            block.number = count_of(row.cells[interval_at].text);
            if (std::ranges::find(interval_roles(), row.cells[role_at].text) !=
                interval_roles().end())
                block.stated_role = row.cells[role_at].text;
            block.table.file = source.file;
            block.table.delimiter = ',';
            set_columns(file, block, names, name_texts, unit_texts);
            file.blocks.push_back(std::move(block));
        }
        before = now;
        for (const std::size_t each : {test_at, interval_at, role_at})
            row.cells[each].text.clear();  // texts, and the number that the block has
        add_row(file, file.blocks.back(), std::move(row));
    }
}

}  // namespace

/// Table that `import FILE --tidy` writes: test, number and role of the interval, line of the file
/// and quantities in SI units, with a row of units.
Layout tidy_layout() {
    return {"tidy", "table that --tidy wrote", is_tidy, read_tidy};
}

}  // namespace pendular
