#include "data/recordings/filled_down.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>

#include "data/recordings/point_roles.h"
#include "data/recordings/point_texts.h"

namespace pendular {
namespace {

/// Whether two neighbouring rows repeat a text, which merged cells never do.
bool repeats_in_rows(const Table& table, std::size_t column) {
    for (std::size_t i = 1; i < table.rows.size(); ++i) {
        const std::string& text = table.rows[i].cells[column].text;
        if (!text.empty() && text == table.rows[i - 1].cells[column].text) return true;
    }
    return false;
}

/// Number of different texts in a column.
std::size_t different_texts(const Table& table, std::size_t column) {
    std::set<std::string> texts;
    for (const Row& row : table.rows)
        if (!row.cells[column].text.empty()) texts.insert(row.cells[column].text);
    return texts.size();
}

/// Indices of the rows whose cell is empty.
std::vector<std::size_t> empty_rows(const Table& table, std::size_t column) {
    std::vector<std::size_t> rows;
    for (std::size_t i = 0; i < table.rows.size(); ++i)
        if (table.rows[i].cells[column].text.empty()) rows.push_back(i);
    return rows;
}

/// Fills the empty cells of a column that each have a value above them.
Remark filled(Block& block, std::size_t column, const std::vector<std::size_t>& empty) {
    Remark remark{.kind = Remark::Kind::filled_down,
                  .files = {block.table.file},
                  .count = empty.size(),
                  .names = {block.columns[column].name}};
    for (const std::size_t row : empty) {
        Row& below = block.table.rows[row];
        below.cells[column].text = block.table.rows[row - 1].cells[column].text;
        add_line(remark.lines, below.line);
    }
    return remark;
}

/// Whether the empty cells of a column may be those of merged cells.
bool may_be_merged(const Table& table, std::size_t column) {
    return !table.rows.empty() && !table.rows.front().cells[column].text.empty() &&
           !is_answer(table.rows.front().cells[column].text) && !repeats_in_rows(table, column);
}

/// Empty rows of a column of groups; none where all cells have a value, or none has.
/// @throws InputError where a value is missing rather than that of a group
std::vector<std::size_t> rows_to_fill(const Block& block, std::size_t column) {
    const Table& table = block.table;
    std::vector<std::size_t> empty = empty_rows(table, column);
    if (empty.empty() || empty.size() == table.rows.size()) return {};
    if (empty.front() != 0 && !repeats_in_rows(table, column)) return empty;
    if (different_texts(table, column) < 2) return {};
    const Row& row = table.rows[empty.front()];
    throw InputError({table.file, row.line, row.cells[column].column},
                     fmt::format("the column '{}' has no value in this row, but repeats it in "
                                 "others: write into each row to which group it belongs",
                                 block.columns[column].name));
}

bool names_groups(const BlockColumn& column) {
    return column.quantity.empty() && names_tests(column.name);
}

/// Indices of the rows, but the first, in which a column of names begins a group.
std::set<std::size_t> begins_of_groups(const Block& block) {
    std::set<std::size_t> begins;
    for (std::size_t column = 0; column < block.columns.size(); ++column) {
        if (!names_groups(block.columns[column])) continue;
        std::string before;
        for (std::size_t i = 0; i < block.table.rows.size(); ++i) {
            const std::string& text = block.table.rows[i].cells[column].text;
            if (text.empty() || text == before) continue;
            if (!before.empty()) begins.insert(i);
            before = text;
        }
    }
    return begins;
}

/// @throws InputError at an empty cell in which a group begins: whether the value above holds for
///         this group too is not known
void refuse_across_groups(const Block& block, std::size_t column,
                          const std::vector<std::size_t>& empty,
                          const std::set<std::size_t>& begins) {
    const auto across =
        std::ranges::find_if(empty, [&](std::size_t row) { return begins.contains(row); });
    if (across == empty.end()) return;
    const Row& row = block.table.rows[*across];
    throw InputError({block.table.file, row.line, row.cells[column].column},
                     fmt::format("another group begins in this row, and the column '{}' has no "
                                 "value for it: write into each row which value it has",
                                 block.columns[column].name));
}

}  // namespace

std::vector<Remark> fill_down(Block& table) {
    const std::set<std::size_t> begins = begins_of_groups(table);
    std::vector<Remark> found;
    std::vector<std::vector<std::size_t>> groups;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        const BlockColumn& column = table.columns[i];
        const bool names = names_groups(column);
        const bool condition = column.quantity.empty() && names_condition(column);
        const bool level = column.quantity == "preshear_stress" && !column.of_errors;
        if (!names && !condition && !level) continue;
        // A measured temperature, say, may well lack values.
        if (condition && !names && !may_be_merged(table.table, i)) continue;
        groups.push_back(rows_to_fill(table, i));
        if (level) refuse_across_groups(table, i, groups.back(), begins);
        if (!groups.back().empty()) found.push_back(filled(table, i, groups.back()));
    }
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        const BlockColumn& column = table.columns[i];
        if (column.quantity != "preshear_shear_stress" || column.of_errors) continue;
        // Each row may have a preshear of its own, of which one value is missing.
        const std::vector<std::size_t> empty = empty_rows(table.table, i);
        if (!empty.empty() && std::ranges::find(groups, empty) != groups.end())
            found.push_back(filled(table, i, empty));
    }
    return found;
}

}  // namespace pendular
