#include "data/files/formats/missing_values.h"

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "data/files/missing_mark.h"
#include "data/quantities/number.h"

namespace pendular {
namespace {

/// Values that the user or a line such as "missing value: -999" declares missing.
std::vector<std::string> declared_values(const BlockFile& file, const FileFormat& format) {
    std::vector<std::string> declared = format.missing;
    for (const Fact& fact : file.facts) {
        const std::string key = in_small_letters(fact.key);
        for (const std::string_view word :
             {"missing value", "missing_value", "nodata", "no data", "fehlwert", "_fillvalue"})
            if (key.find(word) != std::string::npos) declared.push_back(fact.value);
    }
    return declared;
}

bool is_declared(const std::string& cell, const std::vector<std::string>& declared) {
    const auto number = parse_number(cell);
    return std::ranges::any_of(declared, [&](const std::string& value) {
        const auto same = parse_number(value);
        return cell == value || (number && same && *number == *same);
    });
}

/// Clears the usual missing value in a column of measured values.
void clear_usual(Table& table, std::size_t column) {
    double lowest = std::numeric_limits<double>::infinity();
    bool any = false;
    for (const Row& row : table.rows) {
        const auto number = parse_number(row.cells[column].text);
        if (!number) continue;
        if (*number == usual_missing_value)
            any = true;
        else
            lowest = std::min(lowest, *number);
    }
    if (!any || lowest < usual_missing_value / 2) return;
    for (Row& row : table.rows)
        if (parse_number(row.cells[column].text) == usual_missing_value)
            row.cells[column].text.clear();
}

}  // namespace

void clear_missing_values(BlockFile& file, const FileFormat& format) {
    const std::vector<std::string> declared = declared_values(file, format);
    for (Block& block : file.blocks) {
        for (Row& row : block.table.rows)
            for (std::size_t i = 0; i < block.columns.size(); ++i) {
                std::string& cell = row.cells[i].text;
                if (block.columns[i].quantity.empty() || cell.empty()) continue;
                if (marks_no_value(cell) || is_declared(cell, declared)) cell.clear();
            }
        for (std::size_t i = 0; i < block.columns.size(); ++i)
            if (!block.columns[i].quantity.empty()) clear_usual(block.table, i);
    }
}

}  // namespace pendular
