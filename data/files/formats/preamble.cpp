#include "data/files/formats/preamble.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <optional>
#include <set>
#include <string_view>

#include "data/files/column_names.h"
#include "data/files/formats/stacked_rows.h"
#include "data/files/formats/statistics_below.h"
#include "data/files/header_cell.h"
#include "data/files/missing_mark.h"
#include "data/quantities/number.h"

namespace pendular {
namespace {

/// Lines among which the names are sought, more than the headers of instruments have, and their
/// cells, as many as a table has columns: a name takes some microseconds to look up.
constexpr std::size_t most_lines = 200, most_cells_examined = 1000;

/// A line above the rows of numbers, with the kinds of its cells.
struct ExaminedLine {
    std::size_t index = 0;
    std::size_t cells = 0;
    std::size_t numbers = 0, units = 0, texts = 0;
    bool comment = false;

    std::size_t filled() const { return numbers + units + texts; }
    /// Whether the line may be a row of the table, which may also have a status or a date.
    bool is_row() const { return numbers >= 2 && numbers >= texts && units == 0; }
};

ExaminedLine examined(const Row& row, std::size_t index) {
    ExaminedLine line{.index = index, .cells = row.cells.size()};
    line.comment = row.cells[0].text.starts_with('#');
    for (const auto& [text, column] : row.cells) {
        if (marks_no_value(text)) continue;
        if (is_number(text))
            ++line.numbers;
        else if (text.starts_with('[') && text.ends_with(']'))
            ++line.units;
        else
            ++line.texts;
    }
    return line;
}

/// Lines that are not blank up to the first row of the table, which is the last of them. That is
/// the first of two rows in succession with as many cells. Empty if there is none.
std::vector<ExaminedLine> lines_above_rows(const SourceLines& source, char delimiter) {
    std::vector<ExaminedLine> lines;
    for (std::size_t i = 0; i < std::min(source.lines.size(), most_lines); ++i) {
        if (source.lines[i].find_first_not_of(" \t,;\r") == std::string_view::npos) continue;
        const ExaminedLine line = examined(source.row(i, delimiter), i);
        if (line.cells > most_cells_examined) return {};
        const bool follows = !lines.empty() && lines.back().is_row() && line.is_row() &&
                             lines.back().cells == line.cells;
        if (follows) return lines;
        lines.push_back(line);
    }
    const bool single =
        source.lines.size() <= most_lines && !lines.empty() && lines.back().is_row();
    if (!single) lines.clear();
    return lines;
}

/// Number of different quantities that the cells of a line name.
std::ptrdiff_t named_quantities(const Row& row) {
    std::set<std::string_view> named;
    for (const Cell& cell : row.cells) {
        const HeaderCell parts = parse_header_cell(cell.text);
        const std::string_view quantity = meaning_of_column(parts.name, parts.unit).quantity;
        if (!quantity.empty()) named.insert(quantity);
    }
    return std::ssize(named);
}

/// Index in `lines` of the names of the columns.
std::optional<std::size_t> place_of_names(const SourceLines& source, char delimiter,
                                          const std::vector<ExaminedLine>& lines) {
    std::optional<std::size_t> place;
    std::ptrdiff_t most = -1;
    for (std::size_t k = 0; k + 1 < lines.size(); ++k) {
        const ExaminedLine& line = lines[k];
        const bool as_many = line.texts >= 2 && line.texts + 1 >= lines.back().filled();
        if (line.comment || line.numbers > 0 || !as_many) continue;
        const std::ptrdiff_t named = named_quantities(source.row(line.index, delimiter));
        if (named > most) place = k, most = named;
    }
    return place;
}

/// Separator of two cells of a statement: the comma of "2,5 g" is part of a number in a file whose
/// delimiter it is, and a blank would make two numbers of it. Two numbers stay apart.
std::string_view between_cells(std::string_view before, std::string_view after, char delimiter,
                               std::string_view line) {
    if (before.empty()) return "";
    const std::string joined = fmt::format("{}{}{}", before, delimiter, after);
    const std::string_view apart = delimiter == ',' ? ", " : "; ";
    constexpr std::string_view digits = "0123456789";
    if (digits.find(before.back()) != std::string_view::npos &&
        digits.find(after.front()) != std::string_view::npos && delimiter == ',' &&
        line.find(joined) != std::string_view::npos)
        return ",";
    const bool both = before.find_first_of(digits) != std::string_view::npos &&
                      after.find_first_of(digits) != std::string_view::npos;
    return both || after.find_first_of(":=") != std::string_view::npos ? apart : " ";
}

/// Adds what a line of a preamble states. Commas and the like after the value are empty cells.
/// @param line the line as in the file; empty: a decimal comma is not sought in it
void add_stated(const Row& row, char delimiter, std::string_view line, BlockFile& file) {
    std::vector<std::string_view> filled;
    for (const Cell& cell : row.cells)
        if (!cell.text.empty()) filled.emplace_back(cell.text);
    if (filled.empty()) return;
    std::string_view key = filled[0];
    while (key.starts_with('#'))
        key = trimmed(key.substr(1));
    std::string value;
    const std::size_t mark = key.find_first_of(":=");
    if (mark != std::string_view::npos) {
        value = trimmed(key.substr(mark + 1));
        key = trimmed(key.substr(0, mark));
    }
    // Cells behind one that is a name are values of their own.
    if (mark == std::string_view::npos) line = {};
    for (std::size_t i = 1; i < filled.size(); ++i) {
        value += between_cells(i == 1 ? value : filled[i - 1], filled[i], delimiter, line);
        value += filled[i];
    }
    if (key.empty()) return;
    if (!value.empty()) return file.add_fact({std::string(key), value, row.line});
    std::string title = "title";
    for (int number = 2; file.known_keys.contains(title); ++number)
        title = fmt::format("title {}", number);
    file.add_fact({title, std::string(key), row.line});
}

}  // namespace

namespace {

/// Whether a line ends the table that stands above it: its first cell is a word, such as "Mean", or
/// signs around one, as in "*** End ***".
bool begins_with_word(const Row& row) {
    const auto first =
        std::ranges::find_if(row.cells, [](const Cell& cell) { return !cell.text.empty(); });
    if (first == row.cells.end() || marks_no_value(first->text)) return false;
    const std::string_view signs = "*=~<_([";
    const auto c = static_cast<unsigned char>(
        first->text[std::min(first->text.find_first_not_of("*-=~<_([ "), first->text.size() - 1)]);
    return std::isalpha(c) || c > 0x7f ||
           signs.find(static_cast<char>(c)) != std::string_view::npos;
}

/// Index of the first cell with a text.
std::size_t first_filled_cell(const Row& row) {
    const auto first =
        std::ranges::find_if(row.cells, [](const Cell& cell) { return !cell.text.empty(); });
    return static_cast<std::size_t>(first - row.cells.begin());
}

/// Whether a column counts the rows of a table, as 1, 2, 3: no word there is a value that could not
/// be measured.
bool counts_rows(const SourceLines& source, std::size_t begin, std::size_t column, char delimiter) {
    constexpr std::size_t fewest = 3, most = 20;
    std::size_t rows = 0;
    std::optional<double> before;  // a time usually begins at 0, and in steps of another size
    for (std::size_t i = begin; i < source.lines.size() && rows < most; ++i) {
        if (first_filled_line(source, i) != i || source.lines[i].starts_with('#')) continue;
        const Row row = source.row(i, delimiter);
        const auto number =
            column < row.cells.size() ? parse_number(row.cells[column].text) : std::nullopt;
        if (!number) continue;
        if (*number != before.value_or(0) + 1) return false;
        before = number;
        ++rows;
    }
    return rows >= fewest;
}

/// Whether a line is no row of a table whose rows have a first number in a column: it has a word
/// there, as in "Mean;20,1;5,0", or alone, as in "Step 2: 8 kPa". Where most of its cells are
/// numbers, only a word for a statistic makes it none, unless the column counts the rows: "OL" or a
/// number that cannot be read is a fault of a row.
bool stands_for_no_row(const Row& row, std::size_t column, bool counted = false) {
    if (!begins_with_word(row)) return false;
    const std::size_t first = first_filled_cell(row);
    const auto numbers =
        std::ranges::count_if(row.cells, [](const Cell& cell) { return is_number(cell.text); });
    if (2 * numbers >= std::ssize(row.cells) && !counted && !names_statistic(row.cells[first].text))
        return false;
    const bool alone =
        std::ranges::all_of(row.cells.begin() + static_cast<std::ptrdiff_t>(first) + 1,
                            row.cells.end(), [](const Cell& cell) { return cell.text.empty(); });
    return alone || first == column || column >= row.cells.size() ||
           !is_number(row.cells[column].text);
}

/// Whether a line may begin with a word, told without splitting it.
bool may_begin_with_word(std::string_view line) {
    const std::size_t first = line.find_first_not_of(" \t,;\"");
    return first != std::string_view::npos &&
           std::string_view("0123456789.+#").find(line[first]) == std::string_view::npos;
}

/// Lines below the names that are no rows of numbers: some among the rows and some below them.
struct LinesOfWords {
    std::vector<std::size_t> among, below;
    std::size_t rows = 0;
    bool other_table = false;  ///< whether names of further columns stand among them
};

/// Whether a line has several texts and no number, as the names of columns.
bool may_be_names(const Row& row) {
    std::size_t texts = 0;
    for (const Cell& cell : row.cells) {
        if (is_number(cell.text)) return false;
        texts += !cell.text.empty();
    }
    return texts > 1;
}

LinesOfWords lines_of_words(const SourceLines& source, std::size_t begin, std::size_t column,
                            char delimiter) {
    LinesOfWords found;
    const bool counted = counts_rows(source, begin, column, delimiter);
    for (std::size_t i = begin; i < source.lines.size(); ++i) {
        if (first_filled_line(source, i) != i || source.lines[i].starts_with('#')) continue;
        if (may_begin_with_word(source.lines[i]) &&
            stands_for_no_row(source.row(i, delimiter), column, counted)) {
            found.below.push_back(i);
            continue;
        }
        ++found.rows;
        found.other_table |= std::ranges::any_of(found.below, [&](std::size_t line) {
            return may_be_names(source.row(line, delimiter));
        });
        std::ranges::copy(found.below, std::back_inserter(found.among));
        found.below.clear();
    }
    return found;
}

/// Leaves out lines of statistics below the rows of a table. Recordings are longer than that.
void take_statistics_below(SourceLines& source, std::size_t first, char delimiter,
                           BlockFile& file) {
    constexpr std::size_t most_rows = 1000;
    if (source.lines.size() > first + most_rows) return;
    std::vector<std::size_t> places;
    std::vector<Row> rows;
    for (std::size_t i = first; i < source.lines.size(); ++i) {
        if (first_filled_line(source, i) != i || source.lines[i].starts_with('#')) continue;
        places.push_back(i);
        rows.push_back(source.row(i, delimiter));
    }
    for (const std::size_t k : rows_of_statistics(rows)) {
        source.lines[places[k]] = {};
        skip_line(file, static_cast<int>(places[k]) + 1, Remark::Kind::after_interval);
    }
}

/// Leaves out a line of words, and keeps a text that is alone in it as a title.
void leave_out_words(SourceLines& source, std::size_t line, char delimiter, BlockFile& file) {
    const Row row = source.row(line, delimiter);
    if (filled_cells(row) == 1)
        file.titles.push_back({row.cells[first_filled_cell(row)].text, row.line});
    source.lines[line] = {};
    skip_line(file, row.line, Remark::Kind::after_interval);
}

/// Leaves out lines of words among the rows of a table and below them: titles of its parts, means
/// of the columns, signatures, and "End of data".
/// @param first index of the first row
void take_lines_of_words(SourceLines& source, std::size_t first, char delimiter, BlockFile& file) {
    // A table of more titles than that is none of numbers with a few words among them.
    constexpr std::size_t most_below = 20, fewest_rows = 3, rows_of_a_title = 3;
    const Row row = source.row(first, delimiter);
    take_statistics_below(source, first, delimiter, file);
    // Where the first row begins with a word, others may do so too.
    if (begins_with_word(row)) return;
    LinesOfWords words = lines_of_words(source, first, first_filled_cell(row), delimiter);
    if (words.other_table || words.rows < fewest_rows || words.below.size() > most_below ||
        rows_of_a_title * words.among.size() > words.rows)
        return;
    std::ranges::copy(words.below, std::back_inserter(words.among));
    for (const std::size_t line : words.among)
        leave_out_words(source, line, delimiter, file);
}

/// Leaves out a title between the names and the first row, such as "Step 1: 4 kPa" above the rows
/// of that step: a single cell with a text.
void take_title_below_names(SourceLines& source, std::size_t names, std::size_t first,
                            char delimiter, BlockFile& file) {
    for (std::size_t i = names + 1; i < first; ++i) {
        if (first_filled_line(source, i) != i || source.lines[i].starts_with('#')) continue;
        const Row row = source.row(i, delimiter);
        if (!begins_with_word(row) || !stands_for_no_row(row, row.cells.size())) continue;
        if (filled_cells(row) == 1) leave_out_words(source, i, delimiter, file);
    }
}

/// Whether all cells of a row are numbers from the third on, and the second too or a unit.
bool has_numbers_behind_name(const Row& row) {
    const auto number = [](const Cell& cell) { return is_number(cell.text); };
    return row.cells.size() > 2 && row.cells.size() <= most_cells_examined &&
           std::all_of(row.cells.begin() + 2, row.cells.end(), number) &&
           (number(row.cells[1]) || is_unit(bare_unit(row.cells[1].text)));
}

/// @throws InputError at a line of one of two that begin with the name of a quantity, with numbers
///         in all other cells but one with a unit
void refuse_lying_table(const SourceLines& source, char delimiter) {
    std::size_t before = 0;
    for (std::size_t i = 0; i < std::min(source.lines.size(), most_lines); ++i) {
        if (first_filled_line(source, i) != i) continue;
        if (source.lines[i].find('"') != std::string_view::npos) return;
        const Row row = source.row(i, delimiter);
        if (!has_numbers_behind_name(row) || named_quantities({row.line, {row.cells.front()}}) == 0)
            return;
        if (before > 0)
            throw InputError({source.file, static_cast<int>(before)},
                             "the names of the columns stand at the begin of lines; they must be "
                             "above columns of numbers: transpose the table, in a spreadsheet by "
                             "Paste special, Transpose");
        before = i + 1;
    }
}

}  // namespace

void take_preamble(SourceLines& source, BlockFile& file) {
    const char delimiter = consistent_delimiter(source, 0, source.lines.size());
    std::vector<ExaminedLine> lines;
    refuse_lying_table(source, delimiter);
    try {
        lines = lines_above_rows(source, delimiter);
        if (!lines.empty()) take_lines_of_words(source, lines.back().index, delimiter, file);
    } catch (const InputError&) {  // a quote, on which the layout has its say
        return;
    }
    const auto names = place_of_names(source, delimiter, lines);
    if (!names) return;
    take_title_below_names(source, lines[*names].index, lines.back().index, delimiter, file);
    if (*names == 0) return;
    // The layout "plain" passes over comments, but that with a row of units does not.
    const auto above = std::span(lines).first(*names);
    const bool comments = std::ranges::all_of(above, &ExaminedLine::comment);
    const ExaminedLine& next = lines[*names + 1];
    if (comments && (next.units == 0 || next.texts > 0)) return;
    for (const ExaminedLine& line : above) {
        add_stated(source.row(line.index, delimiter), delimiter,
                   source.of_sheet ? "" : source.lines[line.index], file);
        source.lines[line.index] = {};
    }
}

bool holds_table(const SourceLines& source) {
    const char delimiter = consistent_delimiter(source, 0, source.lines.size());
    bool named = false;
    for (std::size_t i = 0; i < std::min(source.lines.size(), most_lines); ++i) {
        const Row row = source.row(i, delimiter);
        if (row.cells.size() > most_cells_examined) return true;  // its reader has its say
        if (named && examined(row, i).is_row()) return true;
        named = named || named_quantities(row) > 0;
    }
    return false;
}

}  // namespace pendular
