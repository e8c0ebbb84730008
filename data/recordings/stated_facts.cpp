#include "data/recordings/stated_facts.h"

#include <algorithm>
#include <array>
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

/// The first of two names that share their noun, with it: "Inner diameter" of "Inner/outer
/// diameter", "Innendurchmesser" of "Innen-/Außendurchmesser".
std::string with_noun(std::string first, const std::string& second) {
    if (first.ends_with('-')) {
        first.pop_back();
        for (const std::string noun : {"durchmesser", "radius"})
            if (second.ends_with(noun)) return first + noun;
    }
    const std::size_t blank = second.rfind(' ');
    const bool words = first.size() > 2 && first.find_first_of(" _") == std::string::npos;
    return words && blank != std::string::npos ? first + second.substr(blank) : first;
}

/// The two facts of "Inner diameter / outer diameter: 40 / 80 mm"; none for other facts.
std::vector<StatedFact> both_facts(const Fact& fact) {
    const std::size_t in_key = fact.key.find('/'), in_value = fact.value.find('/');
    if (in_key == std::string::npos || in_value == std::string::npos) return {};
    const NumberText first = number_text(fact.value.substr(0, in_value));
    const NumberText second = number_text(fact.value.substr(in_value + 1));
    if (first.number.empty() || second.number.empty()) return {};
    const std::string& unit = first.unit.empty() ? second.unit : first.unit;
    const std::string name(trimmed(fact.key.substr(in_key + 1)));
    return {taken_apart(with_noun(std::string(trimmed(fact.key.substr(0, in_key))), name),
                        first.number + " " + unit, fact),
            taken_apart(name, second.number + " " + second.unit, fact)};
}

/// Regular expression for a name with a number and a unit, such as "r_i = 20 mm".
const std::string statement =
    R"(([^\d\s,;=:][^\d,;=:]*?)\s*[=:]?\s*(\d+(?:[.,]\d+)?\s*[^\s\d,;]+(?:/[^\s,;]+)?))";

/// Text with one blank for each run of them: three parts of the expression may match a blank, and
/// the search took a second for a line of 300.
std::string with_single_blanks(std::string text) {
    text.erase(std::unique(text.begin(), text.end(),
                           [](char a, char b) { return a == b && (a == ' ' || a == '\t'); }),
               text.end());
    return text;
}

/// Adds the facts in a text of words and numbers such as "r_i 20 mm, r_o 40 mm".
void add_facts_in_words(const std::string& text, const Fact& from, std::vector<StatedFact>& found) {
    static const TextPattern pattern(statement + R"((?=$|[\s,;]))");
    for (const PatternMatch& match : pattern.all(with_single_blanks(text)))
        found.push_back(taken_apart(match.parts[1], match.parts[2], from));
}

bool consists_of_statements(const std::string& text) {
    constexpr std::size_t longest = 120;  // a longer text takes long to search, and says more
    if (text.empty() || text.size() > longest) return false;
    static const TextPattern pattern(statement + R"((?:\s*[,;]\s*)" + statement + ")*");
    return pattern.whole(with_single_blanks(text)).has_value();
}

/// Where the value of a fact ends before further ones: "15 mm" of "15 mm, r_o = 30 mm".
std::size_t end_of_value(const std::string& value) {
    constexpr int most = 4;  // of the commas in a number and in the list of a few values
    std::size_t at = value.find_first_of(",;");
    for (int k = 0; k < most && at != std::string::npos;
         ++k, at = value.find_first_of(",;", at + 1))
        if (consists_of_statements(std::string(trimmed(value.substr(at + 1))))) return at;
    return value.size();
}

/// Adds the facts of a line.
void add_facts(const Fact& fact, std::vector<StatedFact>& found) {
    if (const std::vector<StatedFact> both = both_facts(fact); !both.empty()) {
        found.insert(found.end(), both.begin(), both.end());
        return;
    }
    const bool number = !number_text(fact.value).number.empty();
    const std::size_t end = number ? end_of_value(fact.value) : fact.value.size();
    found.push_back(taken_apart(fact.key, fact.value.substr(0, end), fact));
    if (end < fact.value.size()) add_facts_in_words(fact.value.substr(end + 1), fact, found);
    if (number) return;
    // A comma may have divided "Inner radius 15 mm, outer radius 30 mm".
    if (consists_of_statements(fact.key)) add_facts_in_words(fact.key, fact, found);
    add_facts_in_words(fact.value, fact, found);
}

/// Gives numbers without a unit that of a line such as "Units: mm", if it is one of lengths.
void add_common_unit(std::vector<StatedFact>& facts) {
    constexpr std::array<std::string_view, 10> names = {
        "unit",   "units",    "Einheit",    "Einheiten",   "Maße in",
        "unités", "unidades", "dimensions", "Abmessungen", "unità"};
    const auto common = std::ranges::find_if(facts, [&](const StatedFact& fact) {
        return is_among_names(fact.name, names) && is_unit(fact.text) &&
               Unit(fact.text).same_dimension(Unit("m"));
    });
    if (common == facts.end()) return;
    const std::string unit = common->text;
    for (StatedFact& fact : facts)
        if (fact.unit.empty() && is_number(fact.text)) fact.unit = unit;
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
    for (const Fact& fact : file.facts)
        if (fact.key.size() + fact.value.size() <= longest) add_facts(fact, found);
    add_common_unit(found);
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
