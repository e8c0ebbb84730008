#include "data/files/formats/unit_cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "data/files/column_names.h"
#include "data/files/formats/block_file.h"
#include "data/files/header_cell.h"
#include "data/files/missing_mark.h"
#include "data/quantities/number.h"

namespace pendular {
namespace {

/// Whether a cell repeats the name above it, as one that a workbook merges over both rows does.
bool is_merged_name(const Row& names, const Row& row, std::size_t column) {
    return column < names.cells.size() && !row.cells[column].text.empty() &&
           row.cells[column].text == names.cells[column].text;
}

bool is_bracketed(const Row& names, const Row& row) {
    int units = 0;
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
        const std::string& text = row.cells[i].text;
        if (text.starts_with('[') && text.ends_with(']'))
            ++units;
        else if (!text.empty() && !is_merged_name(names, row, i) &&
                 !(i == 0 && says_units(row.cells[i])))
            return false;
    }
    return units > 0;
}

/// Whether a unit can be that of the quantity that a column names.
bool is_unit_of(const Row& names, std::size_t column, std::string_view unit) {
    return column < names.cells.size() &&
           !meaning_of_column(names.cells[column].text, unit).quantity.empty();
}

/// Whether a text is a value with its unit, as "0.5 s", rather than a unit such as "1/s" or "10
/// mN".
bool is_value(std::string_view text) {
    const std::size_t end = text.find_first_not_of("0123456789.,");
    const std::string_view number = text.substr(0, std::min(end, text.size()));
    return !number.empty() && number.find_first_not_of("10") != std::string_view::npos;
}

bool is_bare(const Row& names, const Row& row) {
    int units = 0, fitting = 0;
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
        const std::string unit = bare_unit(row.cells[i].text);
        if (unit.empty() || unit == "-" || (i == 0 && says_units(row.cells[i])) ||
            is_merged_name(names, row, i))
            continue;
        if (unit == "1" && is_unit_of(names, i, unit)) continue;
        if (!is_unit(unit) || parse_number(unit) || is_value(unit)) return false;
        ++units;
        fitting += is_unit_of(names, i, unit);
    }
    return units >= 2 && fitting >= 1;
}

}  // namespace

bool says_units(const Cell& cell) {
    constexpr std::array words = {"units", "unit",     "einheiten", "einheit", "unités",
                                  "unité", "unidades", "unidad",    "unità"};
    const std::string word = in_small_letters(cell.text);
    return std::ranges::find(words, word) != words.end();
}

bool is_unit_row(const Row& names, const Row& row) {
    return is_bracketed(names, row) || is_bare(names, row);
}

void take_unit_row(Table& table) {
    if (table.rows.size() < 2 || !is_unit_row(table.header, table.rows.front())) return;
    const Row units = table.rows.front();
    table.rows.erase(table.rows.begin());
    for (std::size_t i = 0; i < units.cells.size(); ++i) {
        const std::string unit = bare_unit(units.cells[i].text);
        if (!unit.empty() && unit != "-" && !says_units(units.cells[i]))
            table.header.cells[i].text += fmt::format(" [{}]", unit);
    }
}

}  // namespace pendular
