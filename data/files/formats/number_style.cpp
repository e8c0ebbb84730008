#include "data/files/formats/number_style.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

namespace pendular {
namespace {

/// Parts of a text that consists of digits, marks between them and perhaps an exponent.
struct NumberText {
    std::string_view whole;     ///< sign, digits and marks, without exponent
    std::string_view exponent;  ///< from 'e' or 'E' on
    int points = 0, commas = 0;
};

constexpr std::array<std::string_view, 5> group_blanks = {" ", "'", "\u00a0", "\u202f", "\u2019"};

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// Parts of a text that looks like a number; empty for other texts.
std::optional<NumberText> number_text(std::string_view text) {
    const std::size_t last = text.find_last_of("eE");
    NumberText number{text.substr(0, last), {}};
    if (last != std::string_view::npos) number.exponent = text.substr(last);
    for (const char c : number.exponent.substr(std::min<std::size_t>(1, number.exponent.size())))
        if (!is_digit(c) && c != '+' && c != '-') return std::nullopt;
    bool digits = false;
    for (std::size_t i = 0; i < number.whole.size(); ++i) {
        const char c = number.whole[i];
        digits = digits || is_digit(c);
        number.points += c == '.';
        number.commas += c == ',';
        const bool sign = i == 0 && (c == '+' || c == '-');
        if (!is_digit(c) && c != '.' && c != ',' && !sign) return std::nullopt;
    }
    if (!digits) return std::nullopt;
    return number;
}

/// Whether the one mark in a number may separate thousands: one to three digits that do not begin
/// with 0 are before the mark, three digits after it.
bool may_group(const NumberText& number, char mark) {
    std::string_view digits = number.whole;
    if (digits.starts_with('+') || digits.starts_with('-')) digits.remove_prefix(1);
    const std::size_t at = digits.find(mark);
    return number.exponent.empty() && digits.size() - at == 4 && at >= 1 && at <= 3 &&
           digits.front() != '0';
}

/// Whether the marks `group` in a number separate groups of three digits before the decimal mark.
bool well_grouped(std::string_view number, char group, char decimal) {
    if (number.starts_with('+') || number.starts_with('-')) number.remove_prefix(1);
    if (std::count(number.begin(), number.end(), decimal) > 1) return false;
    std::string_view whole = number.substr(0, number.find(decimal));
    if (number.substr(whole.size()).find(group) != std::string_view::npos) return false;
    if (whole.find(group) == std::string_view::npos) return true;
    bool first = true;
    while (true) {
        const std::size_t end = std::min(whole.find(group), whole.size());
        if (first ? end < 1 || end > 3 : end != 3) return false;
        if (end == whole.size()) return true;
        whole.remove_prefix(end + 1);
        first = false;
    }
}

/// Text without the blanks that separate thousands, as in "1 234,5"; unchanged if there are none.
std::string without_group_blanks(std::string text) {
    for (const std::string_view blank : group_blanks) {
        for (std::size_t at = text.find(blank); at != std::string::npos;
             at = text.find(blank, at)) {
            const std::size_t after = at + blank.size();
            const auto digit = [&](std::size_t i) { return i < text.size() && is_digit(text[i]); };
            const bool three = digit(after) && digit(after + 1) && digit(after + 2);
            if (at == 0 || !is_digit(text[at - 1]) || !three || digit(after + 3)) return text;
            text.erase(at, blank.size());
        }
    }
    return text;
}

}  // namespace

void NumberStyleFinder::look_at(const Table& table) {
    for (const Row& row : table.rows)
        for (std::size_t i = 0; i < row.cells.size(); ++i)
            look_at(table, row, i);
}

void NumberStyleFinder::look_at(const Table& table, const Row& row, std::size_t cell) {
    const std::string& text = row.cells[cell].text;
    // A number with a thousands separator, which may be a blank of several bytes, has at least 5.
    const bool marks = text.find_first_of(",.' ") != std::string::npos || text.size() > 4;
    if (!marks) return;
    const auto keep = [&](Example& example) {
        if (example.text.empty()) example = {text, table.at(row, cell)};
    };
    const std::string joined = without_group_blanks(text);
    if (joined != text && number_text(joined)) keep(grouped_);
    const auto number = number_text(joined);
    if (!number || (number->points == 0 && number->commas == 0)) return;
    if (number->points + number->commas > 1) {
        if (well_grouped(number->whole, ',', '.')) keep(point_), keep(grouped_);
        if (well_grouped(number->whole, '.', ',')) keep(comma_), keep(grouped_);
    } else if (number->commas == 1) {
        keep(may_group(*number, ',') ? open_ : comma_);
    } else {
        keep(points_are_decimal_ || !may_group(*number, '.') ? point_ : open_point_);
    }
}

/// Refuses a number whose mark may be either.
/// @param other number in which the other mark may be either; empty: none
void NumberStyleFinder::refuse_open(const Example& open, char mark, const Example& other) {
    std::string as_decimal = open.text, as_grouped = open.text;
    as_decimal[as_decimal.find(mark)] = '.';
    as_grouped.erase(as_grouped.find(mark), 1);
    throw InputError(
        open.at,
        fmt::format(
            "\"{}\" can be {} (decimal {}) or {} (thousands separator), "
            "and no number of the file decides it; state it in "
            "[[recording]]: decimal = \",\" or decimal = \".\"{}",
            open.text, as_decimal, mark == ',' ? "comma" : "point", as_grouped,
            other.text.empty() ? "" : fmt::format(" (\"{}\" has the other mark)", other.text)));
}

NumberStyle NumberStyleFinder::style(const std::string& decimal) const {
    const Example& contrary = decimal == "," ? point_ : comma_;
    if (!decimal.empty() && !contrary.text.empty())
        throw InputError(contrary.at,
                         fmt::format("\"{}\" is no number with the decimal mark \"{}\" that is "
                                     "stated; correct the number or the stated mark",
                                     contrary.text, decimal));
    if (!decimal.empty())
        return {decimal[0], decimal[0] == ',' || !grouped_.text.empty() || !open_.text.empty()};
    if (!point_.text.empty() && !comma_.text.empty()) {
        const bool point_first = point_.at.line < comma_.at.line;
        const Example& earlier = point_first ? point_ : comma_;
        const Example& later = point_first ? comma_ : point_;
        throw InputError(
            later.at,
            fmt::format("the decimal mark changes in the file: \"{}\" in line {} has a {}, \"{}\" "
                        "here a {}; write all numbers of the file with one mark",
                        earlier.text, earlier.at.line, point_first ? "point" : "comma", later.text,
                        point_first ? "comma" : "point"));
    }
    if (!comma_.text.empty()) return {',', true};
    if (point_.text.empty()) {
        if (!open_.text.empty()) refuse_open(open_, ',', open_point_);
        if (!open_point_.text.empty()) refuse_open(open_point_, '.', open_);
    }
    return {'.', !grouped_.text.empty() || !open_.text.empty()};
}

bool point_may_group(std::string_view text) {
    const auto number = number_text(text);
    return number && number->points == 1 && number->commas == 0 && may_group(*number, '.');
}

std::string rewritten(const std::string& text, const NumberStyle& style) {
    std::string joined = without_group_blanks(text);
    const char group = style.decimal == ',' ? '.' : ',';
    const auto number = number_text(joined);
    if (!number || !well_grouped(number->whole, group, style.decimal)) return text;
    std::erase(joined, group);
    std::replace(joined.begin(), joined.end(), ',', '.');
    return joined;
}

void rewrite_numbers(Table& table, const NumberStyle& style) {
    if (!style.rewrite) return;
    for (Row& row : table.rows)
        for (Cell& cell : row.cells)
            cell.text = rewritten(cell.text, style);
}

}  // namespace pendular
