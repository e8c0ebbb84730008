#include "data/files/formats/cut_row.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>

#include "data/files/csv.h"
#include "data/quantities/number.h"

namespace pendular {
namespace {

/// Number of decimals, with either decimal mark.
std::size_t decimals(std::string_view number) {
    const std::size_t mark = number.find_last_of(".,");
    return mark == std::string_view::npos ? 0 : number.size() - mark - 1;
}

/// Magnitude of a number with either decimal mark; 0 for other texts.
double magnitude(std::string_view text) {
    std::string number(text);
    std::ranges::replace(number, ',', '.');
    return std::abs(parse_number(number).value_or(0));
}

/// Index of the last cell with a text.
std::size_t last_filled(const Row& row) {
    std::size_t last = row.cells.size();
    while (last > 0 && row.cells[last - 1].text.empty())
        --last;
    return last == 0 ? row.cells.size() : last - 1;
}

}  // namespace

bool may_be_cut(std::string_view cell, std::string_view other) {
    constexpr double least_share = 0.25;  // of a number without its last digit it is 0.1
    return cell.size() < other.size() && (cell.empty() || decimals(cell) < decimals(other) ||
                                          magnitude(cell) < least_share * magnitude(other));
}

void leave_out_cut_row(BlockFile& file, int last_line) {
    // A table that people type, as points of failure, may end without a line end, and its last
    // value be the smallest.
    if (file.blocks.empty() || !file.blocks.back().has_column("time")) return;
    auto& rows = file.blocks.back().table.rows;
    if (rows.size() <= fewest_rows_to_cut || rows.back().line != last_line) return;
    const auto others = std::span(rows).first(rows.size() - 1);
    const std::size_t last = last_filled(others.back());
    if (last >= rows.back().cells.size()) return;
    const std::string& cell = rows.back().cells[last].text;
    const bool cut = std::ranges::all_of(
        others, [&](const Row& row) { return may_be_cut(cell, row.cells[last].text); });
    if (!cut) return;
    rows.pop_back();
    skip_line(file, last_line, Remark::Kind::cut_short);
}

}  // namespace pendular
