#include "data/files/formats/block_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "data/files/column_names.h"
#include "data/files/missing_mark.h"
#include "data/quantities/number.h"

namespace pendular {
namespace {

bool same_word(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](unsigned char x, unsigned char y) {
        return std::tolower(x) == std::tolower(y);
    });
}

/// Whether a row ends before a column that is read and that the row before has.
bool is_cut(const Block& block, const Row& row) {
    if (block.table.rows.empty()) return false;
    const Row& before = block.table.rows.back();
    for (std::size_t i = row.cells.size(); i < block.columns.size(); ++i)
        if (!block.columns[i].quantity.empty() && !before.cells[i].text.empty()) return true;
    return false;
}

}  // namespace

std::string BlockFile::fact(std::string_view key) const {
    for (const Fact& each : facts)
        if (same_word(each.key, key)) return each.value;
    return "";
}

void BlockFile::add_fact(Fact fact) {
    std::string word = fact.key;
    for (char& c : word)
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (known_keys.insert(std::move(word)).second) facts.push_back(std::move(fact));
}

Row SourceLines::row(std::size_t line, char delimiter) const {
    return split_cells(lines[line], delimiter, {file, static_cast<int>(line) + 1},
                       InnerQuotes::kept, of_sheet);
}

std::size_t filled_cells(const Row& row) {
    return static_cast<std::size_t>(
        std::ranges::count_if(row.cells, [](const Cell& cell) { return !cell.text.empty(); }));
}

bool is_blank(const Row& row) {
    return std::all_of(row.cells.begin(), row.cells.end(),
                       [](const Cell& cell) { return trimmed(cell.text).empty(); });
}

char consistent_delimiter(const SourceLines& source, std::size_t begin, std::size_t end) {
    char best = '\t';
    std::size_t most = 0;
    end = std::min({end, source.lines.size(), begin + 1000});
    for (const char delimiter : {'\t', ';', ','}) {
        std::size_t consistent = 0;
        std::ptrdiff_t before = -1;
        for (std::size_t i = begin; i < end; ++i) {
            const std::string_view line = source.lines[i];
            const auto count = std::count(line.begin(), line.end(), delimiter);
            consistent += count > 0 && count == before;
            before = count;
        }
        if (consistent > most) best = delimiter, most = consistent;
    }
    return best;
}

int count_of(const std::string& cell) {
    const double number = parse_number(cell).value_or(0);
    return number >= 1 && number <= 1e9 && number == std::floor(number) ? static_cast<int>(number)
                                                                        : 0;
}

std::string bare_unit(std::string_view cell) {
    cell = trimmed(cell);
    const bool brackets = cell.size() >= 2 && ((cell.front() == '[' && cell.back() == ']') ||
                                               (cell.front() == '(' && cell.back() == ')'));
    return std::string(brackets ? trimmed(cell.substr(1, cell.size() - 2)) : cell);
}

void count_interval(BlockFile& file, int line, std::size_t columns) {
    ++file.counts.intervals;
    file.counts.header_cells += columns;
    if (file.counts.intervals > most_intervals)
        throw InputError({file.file, line},
                         fmt::format("more than {} intervals up to this line; split the file into "
                                     "several files",
                                     most_intervals));
    if (file.counts.header_cells > most_header_cells)
        throw InputError(
            {file.file, line},
            fmt::format("{} intervals of up to {} columns: intervals times columns "
                        "are more than {} million; leave out columns that are not "
                        "needed, or split the file into several files",
                        file.counts.intervals, columns, most_header_cells / 1'000'000));
}

void set_columns(BlockFile& file, Block& block, Row header, const std::vector<std::string>& names,
                 const std::vector<std::string>& units, const std::vector<std::string>& details) {
    constexpr std::size_t most_columns = 1000;  // compared in pairs below, as in csv.cpp
    if (names.size() > most_columns)
        throw InputError(
            {block.table.file, header.line},
            fmt::format("has {} columns; at most {} are read", names.size(), most_columns));
    count_interval(file, header.line, names.size());
    struct Best {
        std::size_t column = 0;
        int rank = 0;
    };
    std::vector<std::pair<std::string_view, Best>> best;
    std::vector<ColumnMeaning> meanings;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::string unit = i < units.size() ? units[i] : "";
        meanings.push_back(meaning_of_column(names[i], unit));
        const ColumnMeaning& meaning = meanings.back();
        if (meaning.quantity.empty()) continue;
        const auto known =
            std::ranges::find(best, meaning.quantity, &std::pair<std::string_view, Best>::first);
        if (known == best.end())
            best.push_back({meaning.quantity, {i, meaning.rank}});
        else if (meaning.rank < known->second.rank)
            known->second = {i, meaning.rank};
    }
    header.cells.resize(names.size());
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::string unit = i < units.size() ? units[i] : "";
        const bool used = std::ranges::any_of(best, [&](const auto& each) {
            return each.first == meanings[i].quantity && each.second.column == i;
        });
        BlockColumn column{names[i], unit, used ? std::string(meanings[i].quantity) : "",
                           std::string(set_point_of(names[i], unit))};
        // A text that names no quantity, so that the column is not read.
        const std::string other =
            names[i].empty() ? "" : fmt::format("{}, column {}", names[i], i + 1);
        header.cells[i].text = used ? fmt::format("{} [{}]", column.quantity, unit) : other;
        if (used && unit.empty()) header.cells[i].text = column.quantity;
        if (i < details.size() && !details[i].empty())
            column.name += fmt::format(" ({})", details[i]);
        block.columns.push_back(std::move(column));
    }
    block.table.header = std::move(header);
}

void add_row(BlockFile& file, Block& block, Row row) {
    const std::size_t columns = block.columns.size();
    for (std::size_t i = columns; i < row.cells.size(); ++i) {
        if (row.cells[i].text.empty()) continue;
        throw InputError({block.table.file, row.line, row.cells[i].column},
                         fmt::format("{} cells where the header of line {} has {}; correct or "
                                     "remove this line",
                                     row.cells.size(), block.table.header.line, columns));
    }
    check_cell_count(file.counts.cells += columns, file.file, row.line);
    if (is_cut(block, row)) {
        skip_line(file, row.line, Remark::Kind::cut_short);
        return;
    }
    row.cells.resize(columns);
    for (Cell& cell : row.cells)
        if (marks_no_value(cell.text)) cell.text.clear();
    block.table.rows.push_back(std::move(row));
}

void leave_out(std::vector<Remark>& list, Remark rows) {
    const bool follows = !list.empty() && list.back().kind == rows.kind &&
                         list.back().names == rows.names && list.back().quantity == rows.quantity &&
                         list.back().last_line() + 1 == rows.first_line();
    if (follows)
        list.back().lines.front().last = rows.last_line();
    else
        list.push_back(std::move(rows));
}

void skip_line(BlockFile& file, int line, Remark::Kind reason) {
    leave_out(file.skipped, {.kind = reason, .files = {file.file}, .lines = {{line, line}}});
}

}  // namespace pendular
