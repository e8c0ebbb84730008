#include "data/recordings/stated_facts.h"

#include <cmath>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "data/files/folded_name.h"
#include "data/files/header_cell.h"
#include "data/files/text_pattern.h"
#include "data/quantities/number.h"
#include "data/quantities/units.h"
#include "data/recordings/stated_number.h"

namespace pendular {
namespace {

StatedFact taken_apart(const std::string& key, const std::string& text, const Fact& from) {
    const HeaderCell parts = parse_header_cell(key);
    StatedFact fact{folded_name(parts.name), parts.unit, key, text, from.line};
    if (!parts.unit.empty() && !is_unit(parts.unit)) std::swap(fact.unit, fact.remark);
    fact.whole = from.key + ": " + from.value;
    return fact;
}

/// Number and unit at the begin of a text: "40" and "mm".
struct NumberText {
    std::string number, unit;
};

NumberText number_text(const std::string& text) {
    static const TextPattern pattern(R"(([-+]?\d[\d.,]*(?:[eE][-+]?\d+)?)\s*(.*))");
    const auto found = pattern.whole(trimmed(text));
    return found ? NumberText{found->parts[1], found->parts[2]} : NumberText{};
}

/// The two facts of "Inner diameter / outer diameter: 40 / 80 mm"; none for other facts.
std::vector<StatedFact> both_facts(const Fact& fact) {
    const std::size_t in_key = fact.key.find('/'), in_value = fact.value.find('/');
    if (in_key == std::string::npos || in_value == std::string::npos) return {};
    const NumberText first = number_text(fact.value.substr(0, in_value));
    const NumberText second = number_text(fact.value.substr(in_value + 1));
    if (first.number.empty() || second.number.empty()) return {};
    const std::string& unit = first.unit.empty() ? second.unit : first.unit;
    return {taken_apart(std::string(trimmed(fact.key.substr(0, in_key))), first.number + " " + unit,
                        fact),
            taken_apart(std::string(trimmed(fact.key.substr(in_key + 1))),
                        second.number + " " + second.unit, fact)};
}

/// Facts in a text of words and numbers such as "r_i 20 mm, r_o 40 mm".
void add_facts_in_words(const Fact& fact, std::vector<StatedFact>& found) {
    static const TextPattern pattern(
        R"(([^\d\s,;=:][^\d,;=:]*?)\s*[=:]?\s*(\d+(?:[.,]\d+)?\s*[^\s\d,;]+(?:/[^\s,;]+)?)(?=$|[\s,;]))");
    for (const PatternMatch& match : pattern.all(fact.value))
        found.push_back(taken_apart(match.parts[1], match.parts[2], fact));
}

}  // namespace

std::vector<std::string> lower_case_words(std::string_view text) {
    std::vector<std::string> words(1);
    for (const char c : lower_case(text))
        if (std::string_view(" _-.,:;/()[]'=").find(c) == std::string_view::npos)
            words.back() += c;
        else if (!words.back().empty())
            words.emplace_back();
    if (words.back().empty()) words.pop_back();
    return words;
}

std::vector<StatedFact> stated_facts(const BlockFile& file) {
    // Longer texts are descriptions, and take long to search.
    constexpr std::size_t longest = 300;
    std::vector<StatedFact> found;
    for (const Fact& fact : file.facts) {
        if (fact.key.size() + fact.value.size() > longest) continue;
        const std::vector<StatedFact> both = both_facts(fact);
        found.insert(found.end(), both.begin(), both.end());
        if (!both.empty()) continue;
        found.push_back(taken_apart(fact.key, fact.value, fact));
        if (number_text(fact.value).number.empty()) add_facts_in_words(fact, found);
    }
    return found;
}

namespace {

/// Whether a value is that of a fact in doubt, by its number.
StatedDoubt doubt_of(const StatedNumber& number, std::size_t possible, bool first_possible) {
    if (number.range) return StatedDoubt::range;
    const bool certain = possible == 1 || (number.in_style && first_possible);
    return certain ? StatedDoubt::none : StatedDoubt::other_mark;
}

}  // namespace

std::optional<StatedValue> positive_value(const StatedFact& fact, const char* unit,
                                          const PossibleValues& possible,
                                          const NumberStyle& style) {
    const auto number = stated_number(fact.text, style);
    if (!number) return std::nullopt;
    std::string own_unit = number->unit.empty() ? fact.unit : number->unit;
    // TRIOS writes a stress per torque as "Pa/N.m", which reads as (Pa/N) m elsewhere.
    if (const std::size_t at = own_unit.find("Pa/N.m"); at != std::string::npos)
        own_unit.replace(at, 6, "Pa/(N m)");
    std::vector<double> values;
    bool first_possible = false;
    try {
        const Unit stated(own_unit);
        if (!stated.same_dimension(Unit(unit))) return std::nullopt;
        for (const double reading : number->readings) {
            const double value = stated.to_si(reading);
            if (!(value > 0) || value < possible.least || !(value <= possible.most)) continue;
            first_possible |= reading == number->readings.front();
            values.push_back(value);
        }
    } catch (const std::invalid_argument&) {
        return std::nullopt;
    }
    if (values.empty() || !std::isfinite(values.front())) return std::nullopt;
    return StatedValue{values.front(), fact.line, fact.key, fact.text,
                       doubt_of(*number, values.size(), first_possible)};
}

}  // namespace pendular
