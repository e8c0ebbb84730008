#include "data/files/formats/several_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string_view>

#include "data/files/column_names.h"
#include "data/files/formats/cell_bytes.h"
#include "data/files/formats/stresses_beside.h"
#include "data/files/header_cell.h"
#include "data/input_error.h"
#include "data/quantities/number.h"

namespace pendular {
namespace {

/// Lines among which the first names are sought, as in preamble.cpp; tables of a file, and bytes
/// and lines of all of them, so that a small file cannot use much memory.
constexpr std::size_t most_lines_above = 200, most_tables = 200, most_bytes = std::size_t(1) << 28,
                      most_lines_of_tables = 20'000'000;

/// Number of different quantities that the cells of a line name.
std::size_t quantities_named(const Row& row, std::size_t begin, std::size_t end) {
    std::set<std::string_view> found;
    for (std::size_t i = begin; i < std::min(end, row.cells.size()); ++i) {
        const HeaderCell cell = parse_header_cell(row.cells[i].text);
        const auto quantity = meaning_of_column(cell.name, cell.unit).quantity;
        if (!quantity.empty()) found.insert(quantity);
    }
    return found.size();
}

std::size_t numbers_in(const Row& row) {
    return static_cast<std::size_t>(
        std::ranges::count_if(row.cells, [](const Cell& cell) { return is_number(cell.text); }));
}

/// Line with the names of the columns.
struct NamesLine {
    std::size_t line = 0;
    Row row;
};

/// First of the lines with the most names of quantities, of at least two. Cells of more lines than
/// a header has, and of more columns than are read, are not looked at.
std::optional<NamesLine> names_line(const SourceLines& source, char delimiter) {
    constexpr std::size_t most_columns = 1000;
    std::optional<NamesLine> best;
    std::size_t most = 1;
    for (std::size_t i = 0; i < std::min(source.lines.size(), most_lines_above); ++i) {
        Row row = source.row(i, delimiter);
        if (row.cells.size() > most_columns) return std::nullopt;
        const std::size_t named = numbers_in(row) > 0 ? 0 : quantities_named(row, 0, most_columns);
        if (named <= most) continue;
        most = named;
        best = NamesLine{i, std::move(row)};
    }
    return best;
}

/// Indices of the cells with which the names of each of several tables begin; one or none where
/// they are those of one table.
std::vector<std::size_t> begins_of_tables(const Row& names) {
    const auto first =
        std::ranges::find_if(names.cells, [](const Cell& cell) { return !cell.text.empty(); });
    std::vector<std::size_t> begins;
    for (auto cell = first; cell != names.cells.end(); ++cell)
        if (cell->text == first->text)
            begins.push_back(static_cast<std::size_t>(cell - names.cells.begin()));
    for (std::size_t k = 0; k < begins.size(); ++k) {
        const std::size_t end = k + 1 < begins.size() ? begins[k + 1] : names.cells.size();
        if (quantities_named(names, begins[k], end) < 2) return {};
    }
    return begins;
}

/// Line with the cells from `begin` up to `end`; those before are blank. In a sheet their
/// delimiters stay, since a cell's place is its number.
std::string cells_of_line(std::string_view line, char delimiter, std::size_t begin, std::size_t end,
                          bool of_sheet) {
    const std::vector<std::size_t> bytes = bytes_of_cells(line, delimiter);
    const std::size_t cells = bytes.size() - 1;
    if (begin >= cells) return "";
    const std::size_t from = bytes[begin], to = bytes[std::min(end, cells)] - 1;
    std::string text(of_sheet ? begin : 0, delimiter);
    if (!of_sheet) text.append(characters_in(line.substr(0, from)), ' ');
    return text.append(line.substr(from, to - from));
}

/// First text of the lines above the names in the cells of a table.
std::string title_above(const SourceLines& source, std::size_t names, char delimiter,
                        std::size_t begin, std::size_t end) {
    for (std::size_t i = names; i-- > 0;) {
        const Row row = source.row(i, delimiter);
        for (std::size_t k = begin; k < std::min(end, row.cells.size()); ++k)
            if (!row.cells[k].text.empty()) return row.cells[k].text;
        if (filled_cells(row) > 0) return "";
    }
    return "";
}

std::string or_number(std::string title, std::size_t table) {
    return title.empty() ? fmt::format("table {}", table + 1) : std::move(title);
}

SeveralTables side_by_side(const SourceLines& source, const NamesLine& names, char delimiter) {
    const std::vector<std::size_t> begins = begins_of_tables(names.row);
    std::size_t bytes = 0;
    for (const std::string_view line : source.lines)
        bytes += line.size();
    SeveralTables found;
    if (begins.size() < 2 || begins.size() > most_tables || bytes > most_bytes / begins.size())
        return found;
    for (std::size_t k = 0; k < begins.size(); ++k) {
        const std::size_t end = k + 1 < begins.size() ? begins[k + 1] : names.row.cells.size();
        TablePart part{or_number(title_above(source, names.line, delimiter, begins[k], end), k),
                       source};
        for (std::size_t i = 0; i < source.lines.size(); ++i) {
            // Lines above the names with one text, such as a radius, concern all tables.
            if (i < names.line && filled_cells(source.row(i, delimiter)) < 2) continue;
            part.source.lines[i] = found.texts.emplace_back(
                cells_of_line(source.lines[i], delimiter, begins[k], end, source.of_sheet));
        }
        // The titles are known.
        if (names.line > 0) part.source.lines[names.line - 1] = {};
        found.parts.push_back(std::move(part));
    }
    return found;
}

/// Whether a line may be one between two tables: it is no row of numbers.
bool is_between(const SourceLines& source, std::size_t line, char delimiter) {
    return numbers_in(source.row(line, delimiter)) < 2;
}

/// Last text of the lines from one to another.
std::string last_text(const SourceLines& source, std::size_t begin, std::size_t end,
                      char delimiter) {
    for (std::size_t i = end; i-- > begin;)
        for (const Cell& cell : source.row(i, delimiter).cells)
            if (!cell.text.empty()) return cell.text;
    return "";
}

SeveralTables one_below_another(const SourceLines& source, const NamesLine& names, char delimiter) {
    const std::string_view header = source.lines[names.line];
    std::vector<std::size_t> begins = {0}, headers = {names.line};
    for (std::size_t i = names.line + 1; i < source.lines.size(); ++i) {
        if (source.lines[i] != header) continue;
        std::size_t begin = i;
        while (begin > headers.back() + 1 && is_between(source, begin - 1, delimiter))
            --begin;
        headers.push_back(i);
        begins.push_back(begin);
    }
    SeveralTables found;
    if (begins.size() < 2 || begins.size() > most_tables ||
        source.lines.size() > most_lines_of_tables / begins.size())
        return found;
    for (std::size_t k = 0; k < begins.size(); ++k) {
        const std::size_t end = k + 1 < begins.size() ? begins[k + 1] : source.lines.size();
        TablePart part{
            or_number(last_text(source, begins[k], headers[k], delimiter), k),
            {source.file, std::vector<std::string_view>(source.lines.size()), source.of_sheet}};
        std::copy(source.lines.begin() + static_cast<std::ptrdiff_t>(begins[k]),
                  source.lines.begin() + static_cast<std::ptrdiff_t>(end),
                  part.source.lines.begin() + static_cast<std::ptrdiff_t>(begins[k]));
        found.parts.push_back(std::move(part));
    }
    return found;
}

}  // namespace

SeveralTables tables_in(const SourceLines& source) {
    try {
        const char delimiter = consistent_delimiter(source, 0, source.lines.size());
        const auto names = names_line(source, delimiter);
        SeveralTables found;
        if (names) found = side_by_side(source, *names, delimiter);
        if (names && found.parts.empty()) found = one_below_another(source, *names, delimiter);
        return found.parts.empty() ? stresses_beside(source, delimiter) : std::move(found);
    } catch (const InputError&) {  // a quote, on which the layout has its say
        return {};
    }
}

}  // namespace pendular
