#include "data/recordings/stated_number.h"

#include <algorithm>
#include <utility>

#include "data/files/header_cell.h"
#include "data/files/text_pattern.h"
#include "data/quantities/number.h"

namespace pendular {
namespace {

/// Digits and marks of a number, without what separates groups as blanks do.
std::string without_blanks(const std::string& number) {
    std::string plain;
    for (const char c : number)
        if (static_cast<unsigned char>(c) < 0x80 && c != ' ' && c != '\'') plain += c;
    return plain;
}

/// Value of a number one of whose marks is the decimal mark, and the other separates groups.
std::optional<double> with_decimal(std::string text, char decimal) {
    std::erase(text, decimal == ',' ? '.' : ',');
    std::ranges::replace(text, ',', '.');
    return parse_number(text);
}

/// Whether all marks of one kind have three digits behind them, and one to three before the first.
bool groups_thousands(std::string_view digits, char mark, char decimal) {
    const std::string_view whole = digits.substr(0, digits.rfind(decimal));
    std::size_t at = whole.find(mark);
    if (at == 0 || at > 3 || whole.front() == '0') return false;
    while (at != std::string_view::npos) {
        const std::size_t next = std::min(whole.find(mark, at + 1), whole.size());
        if (next - at != 4) return false;
        at = next == whole.size() ? std::string_view::npos : next;
    }
    return true;
}

/// Readings of a number without blanks.
std::vector<double> readings_of(std::string text, bool grouped, StatedNumber& stated,
                                char decimal) {
    const bool negative = text.starts_with('-');
    if (text.starts_with('-') || text.starts_with('+')) text.erase(0, 1);
    std::vector<std::optional<double>> found;
    const auto points = std::ranges::count(text, '.'), commas = std::ranges::count(text, ',');
    if (points + commas <= 1) {
        const char mark = commas == 1 ? ',' : '.', other = mark == ',' ? '.' : ',';
        found.push_back(with_decimal(text, mark));
        const bool exponent = text.find_first_of("eE") != std::string::npos;
        if (points + commas == 1 && !grouped && !exponent && groups_thousands(text, mark, other)) {
            stated.in_style = mark == decimal;
            found.insert(mark == decimal ? found.end() : found.begin(), with_decimal(text, other));
        }
    } else if (points == 0 || commas == 0 || std::min(points, commas) == 1) {
        const char last = text[text.find_last_of(".,")];
        const bool one_kind = points == 0 || commas == 0;
        const char mark = one_kind ? last : (last == ',' ? '.' : ',');
        const char behind = mark == ',' ? '.' : ',';
        if (groups_thousands(text, mark, behind) && std::ranges::count(text, behind) <= 1)
            found.push_back(with_decimal(text, behind));
    }
    std::vector<double> readings;
    for (const auto& value : found)
        if (value) readings.push_back(negative ? -*value : *value);
    return readings;
}

/// Adds the readings of one number.
void read_number(const std::string& number, const NumberStyle& style, StatedNumber& stated) {
    const std::string plain = without_blanks(number);
    stated.readings = readings_of(plain, plain != number, stated, style.decimal);
}

/// Whether a text may be that of a unit: digits stand in it behind letters, as in "kg/m3" and
/// "kg m-3", or as the numerator of "1/s".
bool may_be_unit(std::string_view text) {
    static const TextPattern factor(R"((?:^|[\s,;:*(+~/±×·])[-+]?\d)");
    return !factor.first(text.starts_with("1/") ? text.substr(1) : text);
}

std::string bare(const std::string& unit) {
    return unit.size() > 2 && unit.front() == '(' && unit.back() == ')' &&
                   unit.find(')') + 1 == unit.size()
               ? unit.substr(1, unit.size() - 2)
               : unit;
}

}  // namespace

const std::string& number_expression() {
    static const std::string expression =
        "([-+]?(?:\\d{1,3}(?:(?:[ ']|\u00a0|\u202f|\u2009|\u2019)\\d{3})+(?!\\d)(?:[.,]\\d+)?"
        "|\\d+(?:[.,]\\d+)*)(?:[eE][-+]?\\d+)?)";
    return expression;
}

std::optional<StatedNumber> stated_number(std::string_view written, const NumberStyle& style) {
    static const TextPattern one(number_expression() + R"(\s*(.*))");
    static const TextPattern with_error(number_expression() + R"(\s*(?:±|\+/-|\+-)\s*)" +
                                        number_expression() + R"(\s*(.*))");
    static const TextPattern range(number_expression() + R"(\s*(?:-|–|to|bis|à|a)\s*)" +
                                   number_expression() + R"(\s*(.*))");
    static const TextPattern unit_first(R"(([^\d\s]\S*)\s+)" + number_expression());
    std::string_view text = trimmed(written);
    while (text.ends_with(',') || text.ends_with(';'))
        text = trimmed(text.substr(0, text.size() - 1));
    StatedNumber stated;
    if (const auto found = range.whole(text)) {
        StatedNumber least, most;
        read_number(found->parts[1], style, least);
        read_number(found->parts[2], style, most);
        if (least.readings.size() != 1 || most.readings.size() != 1 ||
            !(least.readings[0] < most.readings[0]))
            return std::nullopt;
        stated.readings = {(least.readings[0] + most.readings[0]) / 2};
        stated.range = true;
        stated.unit = bare(found->parts[3]);
    } else if (const auto error = with_error.whole(text)) {
        read_number(error->parts[1], style, stated);
        stated.unit = bare(error->parts[3]);
    } else if (const auto behind = unit_first.whole(text); behind && is_unit(behind->parts[1])) {
        read_number(behind->parts[2], style, stated);
        stated.unit = behind->parts[1];
    } else if (const auto plain = one.whole(text)) {
        read_number(plain->parts[1], style, stated);
        stated.unit = bare(plain->parts[2]);
    }
    return stated.readings.empty() || !may_be_unit(stated.unit) ? std::nullopt
                                                                : std::optional(stated);
}

}  // namespace pendular
