#include "data/files/formats/stacked_rows.h"

#include <algorithm>

#include "data/files/column_names.h"
#include "data/files/header_cell.h"
#include "data/quantities/number.h"

namespace pendular {

std::size_t first_filled_line(const SourceLines& source, std::size_t from) {
    while (from < source.lines.size() &&
           trimmed(source.lines[from]).find_first_not_of(",;\t ") == std::string_view::npos)
        ++from;
    return from;
}

bool all_numbers(const Row& row) {
    return std::ranges::all_of(row.cells, [](const Cell& cell) { return is_number(cell.text); });
}

Row headerless_first_row(const SourceLines& source, char& delimiter) {
    const std::size_t first = first_filled_line(source, 0);
    if (first == source.lines.size()) return {};
    delimiter = consistent_delimiter(source, first, source.lines.size());
    if (source.lines.size() < 2)  // `consistent_delimiter` has no preceding line to compare with
        for (const char each : {'\t', ';', ','})
            if (source.lines[first].find(each) != std::string_view::npos) {
                delimiter = each;
                break;
            }
    return source.row(first, delimiter);
}

Row stated_header(const FileFormat& format, int line) {
    Row header{line, {}};
    for (const std::string& column : format.columns)
        header.cells.push_back({column, 1});
    return header;
}

NamesAndUnits stated_columns(const FileFormat& format) {
    NamesAndUnits columns;
    for (const std::string& column : format.columns) {
        const HeaderCell parts = parse_header_cell(column);
        columns.names.push_back(parts.name);
        columns.units.push_back(parts.unit);
    }
    return columns;
}

namespace {

/// Reads stacked intervals: a row of two whole numbers in its first two cells states number and
/// points of the next interval; a point counter that restarts begins one too.
class StackedReader {
  public:
    StackedReader(const SourceLines& source, BlockFile& file) : source_(source), file_(file) {}

    void read(std::size_t begin, const Row& header, const NamesAndUnits& columns) {
        const auto& [names, units] = columns;
        const bool counter = counts_points(names[0]);
        double point = 0;
        for (std::size_t i = begin; i < source_.lines.size(); ++i) {
            const Row row = source_.row(i, file_.delimiter);
            if (is_blank(row)) continue;
            const auto number = parse_number(row.cells[0].text);
            const bool counts_on = counter && number == point + 1;
            if (names.size() > 2 && !counts_on && states_interval(row)) continue;
            if (counter && row.cells[0].text.empty()) {
                skip_line(file_, row.line, Remark::Kind::without_point_number);
                continue;
            }
            const bool restarts = counter && number && *number <= point;
            if (file_.blocks.empty() || announced_ || restarts) begin_block(header, names, units);
            if (number) point = *number;
            add_row(file_, file_.blocks.back(), row);
        }
        // "4;4" at the end is the begin of a row rather than an interval without rows.
        if (announced_ && !file_.blocks.empty())
            skip_line(file_, announced_at_, Remark::Kind::cut_short);
    }

  private:
    bool states_interval(const Row& row) {
        if (row.cells.size() < 2) return false;
        for (std::size_t i = 2; i < row.cells.size(); ++i)
            if (!row.cells[i].text.empty()) return false;
        const int number = count_of(row.cells[0].text), rows = count_of(row.cells[1].text);
        if (number == 0 || rows == 0) return false;
        announced_ = true;
        announced_at_ = row.line;
        number_ = number;
        declared_ = static_cast<std::size_t>(rows);
        return true;
    }

    void begin_block(const Row& header, const std::vector<std::string>& names,
                     const std::vector<std::string>& units) {
        Block block;
        block.number = announced_ ? number_ : static_cast<int>(file_.blocks.size()) + 1;
        if (announced_) block.declared_rows = declared_;
        announced_ = false;
        block.table.file = source_.file;
        block.table.delimiter = file_.delimiter;
        set_columns(file_, block, header, names, units);
        file_.blocks.push_back(std::move(block));
    }

    const SourceLines& source_;
    BlockFile& file_;
    bool announced_ = false;
    int announced_at_ = 0;  ///< line
    int number_ = 0;
    std::size_t declared_ = 0;
};

}  // namespace

void read_stacked_rows(const SourceLines& source, std::size_t begin, const Row& header,
                       const NamesAndUnits& columns, BlockFile& file) {
    StackedReader(source, file).read(begin, header, columns);
}

}  // namespace pendular
