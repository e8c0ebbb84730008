#include "data/files/formats/text_shape.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <vector>

#include "data/files/column_names.h"
#include "data/files/formats/block_file.h"
#include "data/files/formats/text_marks.h"
#include "data/files/header_cell.h"
#include "data/files/missing_mark.h"
#include "data/files/text_file.h"
#include "data/input_error.h"
#include "data/quantities/number.h"

namespace pendular {
namespace {

/// Lines among which the first row of numbers is sought, as in preamble.cpp.
constexpr std::size_t most_header_lines = 200;

bool is_blank_character(char c) {
    return c == ' ' || c == '\t';
}

/// Line of a text: bytes from `begin` to `end`, without the line end.
struct TextLine {
    std::size_t begin = 0, end = 0;

    std::string_view of(const std::string& text) const {
        return std::string_view(text).substr(begin, end - begin);
    }
};

/// First lines of a text.
std::vector<TextLine> first_lines(const std::string& text) {
    std::vector<TextLine> lines;
    std::size_t begin = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
    while (begin < text.size() && lines.size() < most_header_lines) {
        const std::size_t end = std::min(text.find_first_of("\r\n", begin), text.size());
        lines.push_back({begin, end});
        begin = end + (std::string_view(text).substr(end, 2) == "\r\n" ? 2 : 1);
    }
    return lines;
}

/// Comment sign at the begin of a line; empty for none.
std::string_view comment_sign(std::string_view line) {
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    for (const std::string_view sign : {"#", "%", "//"})
        if (line.starts_with(sign))
            return line.substr(
                0, std::max(sign.size(), std::min(line.find_first_not_of(sign[0]), line.size())));
    return "";
}

/// Bytes at which the cells of a line begin, where runs of at least `fewest` blanks divide them.
std::vector<std::size_t> cells_between_blanks(std::string_view line, std::size_t fewest) {
    std::vector<std::size_t> begins;
    std::size_t blanks = fewest;
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (is_blank_character(line[i]) && !quoted) {
            ++blanks;
            continue;
        }
        if (line[i] == '"') quoted = !quoted;
        if (blanks >= fewest || begins.empty()) begins.push_back(i);
        blanks = 0;
    }
    return begins;
}

/// Bytes at which the cells of a line begin, where a bracket and a blank end each: "Time [s] Gap
/// [mm]".
std::vector<std::size_t> cells_after_brackets(std::string_view line) {
    std::vector<std::size_t> begins;
    bool closed = true;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (is_blank_character(line[i])) continue;
        if (closed && i > 0 && !begins.empty() && !is_blank_character(line[i - 1])) return {};
        if (closed) begins.push_back(i);
        closed = line[i] == ']' || line[i] == ')';
    }
    return closed ? begins : std::vector<std::size_t>{};
}

/// Cell without the quotes around it.
std::string_view unquoted(std::string_view cell) {
    const bool quoted = cell.size() > 1 && cell.starts_with('"') && cell.ends_with('"');
    return quoted ? cell.substr(1, cell.size() - 2) : cell;
}

/// Number of the cells of a row of numbers between blanks; 0 for other lines.
std::size_t numbers_between_blanks(std::string_view line) {
    if (line.find_first_of("\t;|") != std::string_view::npos) return 0;
    const std::vector<std::size_t> begins = cells_between_blanks(line, 1);
    std::size_t numbers = 0;
    for (std::size_t k = 0; k < begins.size(); ++k) {
        const std::size_t end = k + 1 < begins.size() ? begins[k + 1] : line.size();
        const std::string_view cell = unquoted(trimmed(line.substr(begins[k], end - begins[k])));
        numbers += is_number(cell);
        if (!is_number(cell) && !marks_no_value(cell)) return 0;
    }
    return numbers >= 2 ? begins.size() : 0;
}

/// First row of the numbers of a text, with the number of its cells; 0 cells for none.
struct FirstRow {
    std::size_t line = 0, cells = 0;
};

/// First of two rows of numbers between blanks in succession, or the only one below a header.
FirstRow row_between_blanks(const std::string& text, const std::vector<TextLine>& lines) {
    FirstRow before;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::string_view line = lines[i].of(text);
        if (trimmed(line).empty()) continue;
        const std::size_t cells = numbers_between_blanks(line);
        if (cells > 0 && cells == before.cells) return before;
        before = {i, cells};
    }
    return {};
}

/// Puts tabs in place of the blanks before the cells of a line, so that each stays at its place.
void divide(std::string& text, const TextLine& line, const std::vector<std::size_t>& begins) {
    for (std::size_t k = 1; k < begins.size(); ++k) {
        std::size_t blank = line.begin + begins[k] - 1;
        while (is_blank_character(text[blank - 1])) {
            text[blank] = ' ';
            --blank;
        }
        text[blank] = '\t';
    }
}

/// Begins of the cells of a line above a table of `cells` columns between blanks; empty for lines
/// of other texts.
std::vector<std::size_t> header_cells(std::string_view line, std::size_t cells) {
    for (const std::vector<std::size_t>& begins :
         {cells_between_blanks(line, 2), cells_between_blanks(line, 1), cells_after_brackets(line)})
        if (begins.size() == cells) return begins;
    return {};
}

/// Whether any cell of a line of names is that of a quantity.
bool names_quantities(std::string_view line, const std::vector<std::size_t>& begins) {
    for (std::size_t k = 0; k < begins.size(); ++k) {
        const std::size_t end = k + 1 < begins.size() ? begins[k + 1] : line.size();
        const HeaderCell cell = parse_header_cell(line.substr(begins[k], end - begins[k]));
        if (!meaning_of_column(cell.name, cell.unit).quantity.empty()) return true;
    }
    return false;
}

/// Begins of the cells of a line that a delimiter divides.
std::vector<std::size_t> cells_between(std::string_view line, char delimiter) {
    std::vector<std::size_t> begins = {0};
    for (std::size_t i = 0; i < line.size(); ++i)
        if (line[i] == delimiter) begins.push_back(i + 1);
    for (std::size_t k = 1; k < begins.size(); ++k)
        --begins[k];  // with the delimiter, which is no part of a name
    return begins;
}

/// Text of a line with blanks in place of its comment sign.
std::string uncommented(std::string_view line) {
    std::string result(line);
    const std::string_view sign = comment_sign(line);
    if (!sign.empty()) std::fill_n(result.begin() + (sign.data() - line.data()), sign.size(), ' ');
    return result;
}

/// Takes the comment sign off the names of the columns if no other line above the numbers has them,
/// and off the lines between them and the numbers, such as units.
/// @param cells_of begins of the cells of a line of names; empty for other lines
template <typename CellsOf>
void uncomment_names(std::string& text, const std::vector<TextLine>& lines, std::size_t row,
                     const CellsOf& cells_of) {
    std::size_t first = row;
    for (std::size_t i = row; i-- > 0;) {
        const std::string_view line = lines[i].of(text);
        if (trimmed(line).empty()) continue;
        if (comment_sign(line).empty()) return;
        const std::string names = uncommented(line);
        const std::vector<std::size_t> begins = cells_of(names);
        if (begins.size() < 2 && first == row && i + 3 >= row) continue;  // a title: "# 4 kPa"
        if (begins.size() < 2) break;
        first = i;
        if (names_quantities(names, begins)) break;
        if (i + 3 < row) return;
    }
    if (first == row) return;
    const std::string top = uncommented(lines[first].of(text));
    if (!names_quantities(top, cells_of(top))) return;
    for (std::size_t i = first; i < row; ++i) {
        const std::string names = uncommented(lines[i].of(text));
        if (cells_of(names).size() >= 2)
            text.replace(lines[i].begin, lines[i].end - lines[i].begin, names);
    }
}

/// Lets other comment signs be '#', of comments above the numbers.
void unify_comments(std::string& text, const std::vector<TextLine>& lines, std::size_t row) {
    for (std::size_t i = 0; i < row; ++i) {
        const std::string_view sign = comment_sign(lines[i].of(text));
        if (!sign.empty())
            std::fill_n(text.begin() + (sign.data() - text.data()), sign.size(), '#');
    }
}

/// Lets blanks stand for the commas between the names above a table of `cells` columns between
/// blanks, as in "# time, torque", and a tab for the first of the blanks above a first column
/// without a name, which numbers the rows. R writes no blank there: the quotes of the first name
/// give way.
void divide_names(std::string& text, const std::vector<TextLine>& lines, std::size_t row,
                  std::size_t cells) {
    for (std::size_t i = 0; i < row; ++i) {
        const auto begin = text.begin() + static_cast<std::ptrdiff_t>(lines[i].begin),
                   end = text.begin() + static_cast<std::ptrdiff_t>(lines[i].end);
        const auto commas = static_cast<std::size_t>(std::count(begin, end, ','));
        if (commas + 1 == cells) std::replace(begin, end, ',', ' ');
        const std::string_view line = lines[i].of(text);
        if (!line.starts_with(' ') && !line.starts_with('"')) continue;
        if (!comment_sign(line).empty() || !header_cells(line, cells).empty() ||
            header_cells(line, cells - 1).empty())
            continue;
        const std::size_t closing = line.starts_with('"') ? line.find('"', 1) : std::string::npos;
        if (closing != std::string::npos) *(begin + static_cast<std::ptrdiff_t>(closing)) = ' ';
        *begin = '\t';
    }
}

/// Divides a table whose cells stand between blanks. Returns whether the text is one.
bool divide_at_blanks(std::string& text, const std::vector<TextLine>& lines) {
    const auto [row, cells] = row_between_blanks(text, lines);
    if (cells == 0) return false;
    // Commas divide cells in "Time, Gap" above "1 234,5 678".
    const bool commas = lines[row].of(text).find(',') != std::string_view::npos;
    for (std::size_t i = 0; commas && i < row; ++i)
        if (lines[i].of(text).find(',') != std::string_view::npos) return false;
    divide_names(text, lines, row, cells);
    const std::size_t columns = cells;
    uncomment_names(text, lines, row,
                    [&](std::string_view line) { return header_cells(line, columns); });
    unify_comments(text, lines, row);
    for (std::size_t i = 0; i < row; ++i)
        if (const std::string_view line = lines[i].of(text); comment_sign(line).empty())
            divide(text, lines[i], header_cells(line, line.starts_with('\t') ? cells - 1 : cells));
    for (std::size_t begin = lines[row].begin; begin < text.size();) {
        const std::size_t end = std::min(text.find_first_of("\r\n", begin), text.size());
        const TextLine line{begin, end};
        if (comment_sign(line.of(text)).empty())
            divide(text, line, cells_between_blanks(line.of(text), 1));
        begin = end + 1;
    }
    return true;
}

/// Whether a line is one between the names and the rows of a Markdown table: "|---|:--:|".
bool is_rule(std::string_view line) {
    return line.find('-') != std::string_view::npos &&
           line.find_first_not_of("|-:+= \t") == std::string_view::npos;
}

/// Divides a table whose cells stand between bars. Returns whether the text is one.
bool divide_at_bars(std::string& text, const std::vector<TextLine>& lines) {
    std::ptrdiff_t before = 0;
    bool found = false;
    for (const TextLine& span : lines) {
        const std::string_view line = span.of(text);
        if (line.find_first_of("\t;") != std::string_view::npos) return false;
        const auto bars = std::ranges::count(line, '|');
        found = found || (bars > 0 && bars == before);
        before = bars;
    }
    if (!found) return false;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find_first_of("\r\n", begin), text.size());
        const auto from = text.begin() + static_cast<std::ptrdiff_t>(begin),
                   to = text.begin() + static_cast<std::ptrdiff_t>(end);
        if (is_rule({from, to})) {
            std::fill(from, to, ' ');
        } else {
            // A bar at either end of the line divides nothing.
            const auto is_bar = [](char c) { return !is_blank_character(c); };
            const auto first = std::find_if(from, to, is_bar);
            if (first != to && *first == '|') *first = ' ';
            const auto last =
                std::find_if(std::reverse_iterator(to), std::reverse_iterator(from), is_bar);
            if (last.base() != from && *last == '|') *last = ' ';
            std::replace(from, to, '|', '\t');
        }
        begin = end + 1;
    }
    return true;
}

/// Lets names in a comment above a table with delimiters be its header.
void uncomment_delimited(std::string& text, const std::vector<TextLine>& lines) {
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::string_view line = lines[i].of(text);
        if (trimmed(line).empty() || !comment_sign(line).empty()) continue;
        if (i == 0) return;
        for (const char delimiter : {'\t', ';', ','}) {
            const Row row = split_cells(line, delimiter, {}, InnerQuotes::kept);
            const auto numbers = std::ranges::count_if(
                row.cells, [](const Cell& cell) { return is_number(cell.text); });
            if (row.cells.size() < 2 || numbers < 2) continue;
            uncomment_names(text, lines, i, [&](std::string_view names) {
                const auto begins = cells_between(names, delimiter);
                return begins.size() == row.cells.size() ? begins : std::vector<std::size_t>{};
            });
            break;
        }
        unify_comments(text, lines, i);
        return;
    }
}

}  // namespace

TextShape shape_text(std::string& text) {
    unify_signs(text);
    join_tabs(text);
    const std::vector<TextLine> lines = first_lines(text);
    if (divide_at_blanks(text, lines)) return TextShape::blanks;
    if (divide_at_bars(text, lines)) return TextShape::bars;
    try {
        uncomment_delimited(text, lines);
    } catch (const InputError&) {  // a quote, on which the layout has its say
    }
    return TextShape::delimited;
}

}  // namespace pendular
