#include "data/files/formats/missing_values.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "data/files/missing_mark.h"
#include "data/quantities/number.h"

namespace pendular {
namespace {

/// Whether a key of a header declares the number that stands for a missing value, as "missing
/// value" does. "Missing values" and "No data points" count rows.
bool declares_missing(std::string_view key) {
    constexpr std::array<std::string_view, 9> keys = {
        "missing value", "missing_value", "nodata",     "nodata value", "nodata_value",
        "no data value", "fehlwert",      "_fillvalue", "fill value"};
    return std::ranges::find(keys, in_small_letters(trimmed(key))) != keys.end();
}

/// Values that the user or a line such as "missing value: -999" declares missing, with decimal
/// points as the cells have.
std::vector<std::string> declared_values(const BlockFile& file, const FileFormat& format) {
    std::vector<std::string> declared = format.missing;
    for (const Fact& fact : file.facts)
        if (declares_missing(fact.key)) declared.push_back(fact.value);
    if (file.numbers.rewrite)
        for (std::string& value : declared)
            value = rewritten(value, file.numbers);
    return declared;
}

bool is_declared(const std::string& cell, const std::vector<std::string>& declared) {
    const auto number = parse_number(cell);
    return std::ranges::any_of(declared, [&](const std::string& value) {
        const auto same = parse_number(value);
        return cell == value || (number && same && *number == *same);
    });
}

/// Clears the cells of a file, and lists them where they are asked for.
class Clearer {
  public:
    explicit Clearer(std::vector<ClearedCell>* cleared) : cleared_(cleared) {}

    void clear(Table& table, std::size_t row, std::size_t column) {
        std::string& text = table.rows[row].cells[column].text;
        if (cleared_) cleared_->push_back({row, column, text});
        text.clear();
    }

    /// Clears the usual missing value in a column of measured values.
    void clear_usual(Table& table, std::size_t column) {
        double lowest = std::numeric_limits<double>::infinity(), missing = 0;
        for (const Row& row : table.rows) {
            const auto number = parse_number(row.cells[column].text);
            if (!number) continue;
            if (is_usual_missing_value(*number) && (missing == 0 || missing == *number))
                missing = *number;
            else
                lowest = std::min(lowest, *number);
        }
        if (missing == 0 || lowest < missing / 2) return;
        for (std::size_t row = 0; row < table.rows.size(); ++row)
            if (parse_number(table.rows[row].cells[column].text) == missing)
                clear(table, row, column);
    }

  private:
    std::vector<ClearedCell>* cleared_;
};

}  // namespace

void clear_missing_values(BlockFile& file, const FileFormat& format,
                          std::vector<ClearedCell>* cleared) {
    const std::vector<std::string> declared = declared_values(file, format);
    Clearer clearer(cleared);
    for (Block& block : file.blocks) {
        for (std::size_t row = 0; row < block.table.rows.size(); ++row)
            for (std::size_t i = 0; i < block.columns.size(); ++i) {
                const std::string& cell = block.table.rows[row].cells[i].text;
                if (block.columns[i].quantity.empty() || cell.empty()) continue;
                if (marks_no_value(cell) || is_declared(cell, declared))
                    clearer.clear(block.table, row, i);
            }
        for (std::size_t i = 0; i < block.columns.size(); ++i)
            if (!block.columns[i].quantity.empty()) clearer.clear_usual(block.table, i);
    }
}

}  // namespace pendular
