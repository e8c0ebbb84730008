#include "data/files/csv.h"

#include <csv.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "data/files/text_file.h"
#include "data/quantities/number.h"

namespace pendular {
namespace {

/// Number of characters in a UTF-8 text.
int characters(std::string_view text) {
    return static_cast<int>(
        std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

/// Parser of CSV lines, based on libcsv. It parses line by line, so that an unclosed quote ends
/// with its line, and byte by byte, to know the positions of cells, which libcsv does not report.
class LineParser {
  public:
    LineParser(std::string file, char delimiter) : file_(std::move(file)) {
        csv_init(&parser_, CSV_STRICT | CSV_STRICT_FINI);
        csv_set_delim(&parser_, static_cast<unsigned char>(delimiter));
    }
    LineParser(const LineParser&) = delete;
    LineParser& operator=(const LineParser&) = delete;
    ~LineParser() { csv_free(&parser_); }

    /// Parses a line of this number (from 1) into cells.
    /// @throws InputError at a quote that does not close or is inside a cell
    Row parse(const std::string& line, int number) {
        texts_.clear();
        Row row{number, {}};
        std::size_t begin = 0;
        for (std::size_t i = 0; i < line.size(); ++i) {
            if (csv_parse(&parser_, &line[i], 1, &LineParser::take, nullptr, this) != 1)
                refuse_quote(line, number, i);
            if (row.cells.size() == texts_.size()) continue;
            add_cell(row, line, begin);
            begin = i + 1;
        }
        if (csv_fini(&parser_, &LineParser::take, nullptr, this) != 0)
            refuse_quote(line, number, line.find('"', begin));
        // libcsv takes an empty last cell for the end of the row.
        if (row.cells.size() == texts_.size()) texts_.emplace_back();
        add_cell(row, line, begin);
        return row;
    }

  private:
    static void take(void* text, std::size_t size, void* self) {
        static_cast<LineParser*>(self)->texts_.emplace_back(static_cast<const char*>(text), size);
    }

    void add_cell(Row& row, const std::string& line, std::size_t begin) const {
        const std::size_t start = std::min(line.find_first_not_of(' ', begin), line.size());
        row.cells.push_back({texts_.back(), characters(line.substr(0, start)) + 1});
    }

    [[noreturn]] void refuse_quote(const std::string& line, int number, std::size_t byte) {
        const int column = characters(line.substr(0, std::min(byte, line.size()))) + 1;
        throw InputError({file_, number, column},
                         "a quote that does not close, or stands within a cell; close it on this "
                         "line or take it out");
    }

    std::string file_;
    csv_parser parser_;
    std::vector<std::string> texts_;
};

/// Most frequent delimiter in a header, outside of quotes and brackets; a comma if there is none.
char detect_delimiter(std::string_view header) {
    constexpr std::array<char, 3> candidates = {'\t', ';', ','};
    std::array<int, 3> counts = {};
    bool quoted = false;
    int brackets = 0;
    for (const char c : header) {
        if (c == '"') quoted = !quoted;
        if (c == '[' || c == '(') ++brackets;
        if (c == ']' || c == ')') --brackets;
        if (quoted || brackets > 0) continue;
        for (std::size_t i = 0; i < candidates.size(); ++i)
            counts[i] += c == candidates[i];
    }
    const auto most = std::max_element(counts.begin(), counts.end());
    return *most == 0 ? ',' : candidates[static_cast<std::size_t>(most - counts.begin())];
}

/// Whether a line is blank, a comment, or delimiters alone, as spreadsheets write empty rows.
bool passed_over(std::string_view line) {
    const std::string_view text = trimmed(line);
    return text.starts_with('#') || text.find_first_not_of(" \t,;") == std::string_view::npos;
}

constexpr std::size_t most_columns = 1000;

void check_header(const Table& table) {
    const auto& cells = table.header.cells;
    if (cells.size() > most_columns)
        throw InputError(table.at_header(most_columns),
                         fmt::format("{} columns, and at most {} are read; remove those that are "
                                     "not needed",
                                     cells.size(), most_columns));
    for (std::size_t i = 0; i < cells.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (cells[i].text.empty() || cells[i].text != cells[j].text) continue;
            throw InputError(
                table.at_header(i),
                fmt::format("column '{}' stands twice; rename or remove one", cells[i].text));
        }
    }
    const bool numbers = std::all_of(cells.begin(), cells.end(), [](const Cell& cell) {
        return parse_number(cell.text) || has_decimal_comma(cell.text);
    });
    if (numbers)
        throw InputError(table.at_header(0),
                         "numbers where the header is needed; put a line with the columns' names "
                         "and units first, like 'Time [s],Torque [mN m]'");
}

void check_length(const Table& table, const Row& row, bool last) {
    const std::size_t expected = table.header.cells.size();
    if (row.cells.size() == expected) return;
    const std::size_t shown = std::min(row.cells.size() - 1, expected);
    const char* const hint =
        table.delimiter == ',' && row.cells.size() > expected
            ? "; if commas are decimal signs here, export with '.' instead"
        : last ? "; this is the last line: if the file was cut off, export it again, "
                 "or remove the line"
               : "; complete or remove this line";
    throw InputError(table.at(row, shown), fmt::format("{} cells where the header has {}{}",
                                                       row.cells.size(), expected, hint));
}

}  // namespace

Table read_table(const std::filesystem::path& path) {
    const std::vector<std::string> lines = read_lines(path);
    Table table{.file = path.string(), .header = {}, .rows = {}};
    std::size_t first = 0;
    while (first < lines.size() && passed_over(lines[first]))
        ++first;
    if (first == lines.size())
        throw InputError({table.file}, "is empty; a header and rows of numbers are needed");

    table.delimiter = detect_delimiter(lines[first]);
    LineParser parser(table.file, table.delimiter);
    table.header = parser.parse(lines[first], static_cast<int>(first) + 1);
    check_header(table);
    for (std::size_t i = first + 1; i < lines.size(); ++i) {
        if (passed_over(lines[i])) continue;
        table.rows.push_back(parser.parse(lines[i], static_cast<int>(i) + 1));
        check_length(table, table.rows.back(), i + 1 == lines.size());
    }
    if (table.rows.empty())
        throw InputError({table.file, table.header.line},
                         "no rows follow the header; at least one is needed");
    return table;
}

std::string csv_cell(std::string_view text) {
    if (text.find_first_of(",;\t\"\n") == std::string_view::npos) return std::string(text);
    std::string result = "\"";
    for (const char c : text)
        result += c == '"' ? std::string("\"\"") : std::string(1, c == '\n' ? ' ' : c);
    return result + '"';
}

}  // namespace pendular
