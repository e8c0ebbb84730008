#include "data/files/csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "data/files/header_cell.h"
#include "data/files/markup.h"
#include "data/files/sheet_path.h"
#include "data/files/text_file.h"
#include "data/quantities/number.h"

namespace pendular {
namespace {

/// Number of characters in a UTF-8 text.
int character_count(std::string_view text) {
    return static_cast<int>(
        std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

/// Splits one line into cells, from left to right.
class LineSplitter {
  public:
    LineSplitter(std::string_view line, char delimiter, const Position& at, InnerQuotes inner,
                 bool of_sheet)
        : line_(line), at_(at), delimiter_(delimiter), inner_(inner), of_sheet_(of_sheet) {}

    Row split() {
        Row row{at_.line, {}};
        while (true) {
            const std::size_t begin = std::min(after_blanks(next_), line_.size());
            const bool quoted = begin < line_.size() && line_[begin] == '"';
            const int place = of_sheet_ ? static_cast<int>(row.cells.size()) + 1 : column(begin);
            row.cells.push_back({quoted ? quoted_cell(begin) : plain_cell(begin), place});
            if (next_ == std::string_view::npos) return row;
            if (row.cells.size() == most_cells_of_line)
                throw InputError(at_, fmt::format("more than {} cells on one line; put the values "
                                                  "of a row on a line of its own, or split the "
                                                  "file into several files",
                                                  most_cells_of_line));
        }
    }

  private:
    bool blank(char c) const { return c == ' ' || (c == '\t' && delimiter_ != '\t'); }

    std::size_t after_blanks(std::size_t from) const {
        while (from < line_.size() && blank(line_[from]))
            ++from;
        return from;
    }

    /// Column of a byte, in characters from 1. Successive calls must proceed from left to right.
    int column(std::size_t byte) {
        column_ += character_count(line_.substr(counted_, byte - counted_));
        counted_ = byte;
        return column_ + 1;
    }

    /// Text from `begin` to the next delimiter; sets `next_` to the byte after that delimiter.
    std::string plain_cell(std::size_t begin) {
        const std::size_t end = std::min(line_.find(delimiter_, begin), line_.size());
        std::string_view text = line_.substr(begin, end - begin);
        if (const std::size_t quote = text.find('"');
            quote != std::string_view::npos && inner_ == InnerQuotes::refused)
            refuse_quote(begin + quote);
        while (!text.empty() && blank(text.back()))
            text.remove_suffix(1);
        next_ = end < line_.size() ? end + 1 : std::string_view::npos;
        return std::string(text);
    }

    std::string quoted_cell(std::size_t begin) {
        std::string text;
        for (std::size_t i = begin + 1; i < line_.size(); ++i) {
            if (line_[i] != '"') {
                text += line_[i];
            } else if (i + 1 < line_.size() && line_[i + 1] == '"') {
                text += line_[i++];
            } else {
                const std::size_t end = after_blanks(i + 1);
                if (end < line_.size() && line_[end] != delimiter_) refuse_quote(i);
                next_ = end < line_.size() ? end + 1 : std::string_view::npos;
                return text;
            }
        }
        refuse_quote(begin);
    }

    [[noreturn]] void refuse_quote(std::size_t byte) {
        throw InputError(
            {at_.file, at_.line, character_count(line_.substr(0, byte)) + 1},
            "a quote is not closed, or is inside a cell; close it on this line or remove it");
    }

    std::string_view line_;
    const Position& at_;
    char delimiter_;
    InnerQuotes inner_;
    bool of_sheet_;  ///< whether columns are those of a spreadsheet, not characters of the line
    std::size_t next_ = 0;  ///< byte at which the next cell begins; npos: no further cell
    std::size_t counted_ = 0;
    int column_ = 0;
};

/// Most frequent delimiter in a header, outside of quotes and brackets; a comma if there is none.
char header_delimiter(std::string_view header) {
    constexpr std::array<char, 3> candidates = {'\t', ';', ','};
    std::array<int, 3> counts = {};
    bool quoted = false, commas_of_units = true;
    int brackets = 0;
    for (std::size_t at = 0; at < header.size(); ++at) {
        const char c = header[at];
        if (c == '"') quoted = !quoted;
        if (c == '[' || c == '(') ++brackets;
        if (c == ']' || c == ')') --brackets;
        if (quoted || brackets > 0) continue;
        for (std::size_t i = 0; i < candidates.size(); ++i)
            counts[i] += c == candidates[i];
        if (c == ',') commas_of_units &= header.substr(at + 1).starts_with(' ');
    }
    // "Drehmoment, mNm;Zeit, s": a comma between name and unit divides no cells.
    const int others = std::max(counts[0], counts[1]);
    if (commas_of_units && others > 1 && counts[2] <= others + 1) counts[2] = 0;
    const auto most = std::max_element(counts.begin(), counts.end());
    return *most == 0 ? ',' : candidates[static_cast<std::size_t>(most - counts.begin())];
}

/// Limit of header cells, which are compared in pairs: their time grows with the square.
constexpr std::size_t most_columns = 1000;

void check_header(const Table& table) {
    const auto& cells = table.header.cells;
    if (cells.size() > most_columns)
        throw InputError(
            table.at_header(most_columns),
            fmt::format("{} columns, more than the limit of {}; remove columns that are not needed",
                        cells.size(), most_columns));
    for (std::size_t i = 0; i < cells.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (cells[i].text.empty() || cells[i].text != cells[j].text) continue;
            // Each stands for the errors of the values before it.
            if (bare_mark(parse_header_cell(cells[i].text)) != ErrorMark::none) continue;
            throw InputError(
                table.at_header(i),
                fmt::format("column '{}' occurs twice; rename or remove one", cells[i].text));
        }
    }
    const bool numbers = std::all_of(cells.begin(), cells.end(),
                                     [](const Cell& cell) { return is_number(cell.text); });
    if (numbers)
        throw InputError(table.at_header(0),
                         "numbers in place of the header; begin the file with a line of the "
                         "columns' names and units, like 'Time [s],Torque [mN m]'");
}

void check_length(const Table& table, const Row& row, bool last) {
    const std::size_t expected = table.header.cells.size();
    if (row.cells.size() == expected) return;
    const std::size_t shown = std::min(row.cells.size() - 1, expected);
    const bool numbered = row.cells.size() == expected + 1 &&
                          parse_number(row.cells[0].text) == 1 && row.line == table.header.line + 1;
    const char* const hint =
        numbered ? "; if the first cell numbers the rows, give its column a name in the header"
        : table.delimiter == ',' && row.cells.size() > expected
            ? "; if commas are decimal signs here, export with '.' instead"
        : last ? "; this is the last line: if the file was cut off, export it again, "
                 "or remove the line"
               : "; complete or remove this line";
    throw InputError(table.at(row, shown),
                     fmt::format("this row has {} column{}, the header {}{}", row.cells.size(),
                                 row.cells.size() == 1 ? "" : "s", expected, hint));
}

}  // namespace

void check_cell_count(std::size_t cells, const std::string& file, int line) {
    if (cells > most_cells)
        throw InputError({file, line},
                         fmt::format("more than {} million cells (rows times columns) up to "
                                     "this line; leave out columns that are not needed, or "
                                     "split the file into several files. Only recordings of a "
                                     "study that are plain tables of numbers may be longer",
                                     most_cells / 1'000'000));
}

bool holds_no_row(std::string_view line) {
    const std::string_view text = trimmed(line);
    return text.starts_with('#') || text.find_first_not_of(" \t,;") == std::string_view::npos;
}

Row row_of(const Table& table, std::string_view line, int number, bool last) {
    Row row = split_cells(line, table.delimiter, {table.file, number}, InnerQuotes::refused,
                          table.of_sheet);
    // Programs end each row, but not the header, with a delimiter.
    while (row.cells.size() > table.header.cells.size() && row.cells.back().text.empty())
        row.cells.pop_back();
    check_length(table, row, last);
    return row;
}

Row split_cells(std::string_view line, char delimiter, const Position& at, InnerQuotes inner,
                bool of_sheet) {
    return LineSplitter(line, delimiter, at, inner, of_sheet).split();
}

Table read_table(const std::filesystem::path& path) {
    const std::string text = read_text(path);
    refuse_markup(path, text);
    return table_of(path.string(), split_lines(text));
}

namespace {

/// Whether a file ended within its last row.
bool is_cut_row(const Table& table, std::string_view line, int number) {
    if (table.rows.size() < fewest_rows_to_cut) return false;
    const Row row = split_cells(line, table.delimiter, {table.file, number}, InnerQuotes::refused,
                                table.of_sheet);
    return row.cells.size() < table.header.cells.size();
}

}  // namespace

Table table_of(const std::string& file, const std::vector<std::string_view>& lines, int* cut) {
    Table table{.file = file, .header = {}, .rows = {}};
    std::size_t first = 0;
    while (first < lines.size() && holds_no_row(lines[first]))
        ++first;
    if (first == lines.size())
        throw InputError({table.file}, "is empty; a header and rows of numbers are needed");

    table.of_sheet = as_sheet(file).has_value();
    table.delimiter = header_delimiter(lines[first]);
    table.header =
        split_cells(lines[first], table.delimiter, {table.file, static_cast<int>(first) + 1},
                    InnerQuotes::kept, table.of_sheet);
    check_header(table);
    for (std::size_t i = first + 1; i < lines.size(); ++i) {
        if (holds_no_row(lines[i])) continue;
        const int number = static_cast<int>(i) + 1;
        const bool last = i + 1 == lines.size();
        if (last && cut && is_cut_row(table, lines[i], number)) {
            *cut = number;
            break;
        }
        table.rows.push_back(row_of(table, lines[i], number, last));
        check_cell_count(table.rows.size() * table.header.cells.size(), table.file, number);
    }
    if (table.rows.empty())
        throw InputError({table.file, table.header.line},
                         "no rows follow the header; at least one is needed");
    return table;
}

std::string csv_cell(std::string_view text) {
    if (text.find_first_of(",;\t\"\n\r") == std::string_view::npos) return std::string(text);
    std::string result = "\"";
    for (const char c : text)
        result += c == '"' ? std::string("\"\"") : std::string(1, c == '\n' || c == '\r' ? ' ' : c);
    return result + '"';
}

std::string csv_text_cell(std::string_view text) {
    const bool formula =
        !text.empty() && std::string_view("=+-@\t\r").find(text.front()) != std::string_view::npos;
    return csv_cell(formula && !parse_number(text) ? "'" + std::string(text) : std::string(text));
}

}  // namespace pendular
