#include "data/recordings/stated_facts.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string_view>

#include "data/files/folded_name.h"
#include "data/files/header_cell.h"
#include "data/files/text_pattern.h"
#include "data/quantities/number.h"
#include "data/quantities/units.h"

namespace pendular {
namespace {

StatedFact taken_apart(const std::string& key, const std::string& text, int line) {
    const HeaderCell parts = parse_header_cell(key);
    return {folded_name(parts.name), parts.unit, key, text, line};
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
                        fact.line),
            taken_apart(std::string(trimmed(fact.key.substr(in_key + 1))),
                        second.number + " " + second.unit, fact.line)};
}

/// Facts in a text of words and numbers such as "r_i 20 mm, r_o 40 mm".
void add_facts_in_words(const Fact& fact, std::vector<StatedFact>& found) {
    static const TextPattern pattern(
        R"(([^\d\s,;=:][^\d,;=:]*?)\s*[=:]?\s*(\d+(?:[.,]\d+)?\s*[^\s\d,;]+(?:/[^\s,;]+)?)(?=$|[\s,;]))");
    for (const PatternMatch& match : pattern.all(fact.value))
        found.push_back(taken_apart(match.parts[1], match.parts[2], fact.line));
}

}  // namespace

std::vector<StatedFact> stated_facts(const BlockFile& file) {
    // Longer texts are descriptions, and take long to search.
    constexpr std::size_t longest = 300;
    std::vector<StatedFact> found;
    for (const Fact& fact : file.facts) {
        if (fact.key.size() + fact.value.size() > longest) continue;
        const std::vector<StatedFact> both = both_facts(fact);
        found.insert(found.end(), both.begin(), both.end());
        if (!both.empty()) continue;
        found.push_back(taken_apart(fact.key, fact.value, fact.line));
        if (number_text(fact.value).number.empty()) add_facts_in_words(fact, found);
    }
    return found;
}

std::optional<double> positive_value(const StatedFact& fact, const char* unit,
                                     const NumberStyle& style) {
    auto [number, own_unit] = number_text(fact.text);
    if (number.empty()) return std::nullopt;
    if (own_unit.empty()) own_unit = fact.unit;
    // TRIOS writes a stress per torque as "Pa/N.m", which reads as (Pa/N) m elsewhere.
    if (const std::size_t at = own_unit.find("Pa/N.m"); at != std::string::npos)
        own_unit.replace(at, 6, "Pa/(N m)");
    try {
        const double value = quantity_in_si(rewritten(number, style) + " " + own_unit, Unit(unit));
        return value > 0 && std::isfinite(value) ? std::optional(value) : std::nullopt;
    } catch (const std::invalid_argument&) {
        return std::nullopt;
    }
}

}  // namespace pendular
