#include "data/recordings/stated_preshear.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "data/files/column_names.h"
#include "data/files/columns.h"
#include "data/files/header_cell.h"
#include "data/files/sheet_path.h"
#include "data/files/text_pattern.h"
#include "data/quantities/number.h"
#include "data/quantities/units.h"
#include "data/recordings/point_roles.h"
#include "data/recordings/stated_facts.h"
#include "data/recordings/stated_number.h"

namespace pendular {
namespace {

/// Whether a word of a text names a preshear: "Vorscherspannung 3 kPa", "pretaglio = 3 kPa".
bool speaks_of_preshear(std::string_view text) {
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find_first_of(" _:=,;()", begin), text.size());
        if (names_preshear(text.substr(begin, end - begin))) return true;
        begin = end + 1;
    }
    return false;
}

/// A stress in a text, by each way to read its number.
struct NamedStress {
    std::vector<double> readings;  ///< [Pa]
    std::string before;            ///< text between the stress before it and this one
    bool grouped_by_blanks = false;
};

/// Stresses in a text such as "σ = 5 kPa; τ = 3.1 kPa"; none where a further number stands before
/// one of them, as in "1 5 kPa". What is in brackets is said of a stress, and is none.
std::vector<NamedStress> stresses_in(std::string text, const NumberStyle& style) {
    static const TextPattern brackets(R"(\([^()]*\d[^()]*\))");
    static const TextPattern stress(
        number_expression() +
        R"(\s*(kPa|Pa|MPa|hPa|mbar|N/cm²|N/cm2|kN/m²|kN/m2|N/m²|N/m2|psi)(?![A-Za-z0-9]))");
    if (const auto found = brackets.first(text))
        text.erase(found->begin, found->end - found->begin);
    std::vector<NamedStress> stresses;
    std::size_t end = 0;
    for (const PatternMatch& match : stress.all(text)) {
        const std::string before = text.substr(end, match.begin - end);
        const auto number = stated_number(match.parts[1], style);
        const std::string_view ends = trimmed(before);
        if (!number || (!ends.empty() && std::isdigit(static_cast<unsigned char>(ends.back()))))
            return {};
        NamedStress& found = stresses.emplace_back();
        found.before = before;
        found.grouped_by_blanks = match.parts[1].find_first_not_of("+-0123456789.,eE") < 99;
        for (const double reading : number->readings)
            found.readings.push_back(Unit(match.parts[2]).to_si(reading));
        end = match.end;
    }
    return stresses;
}

/// Normal stress [Pa] of the preshear that the name of a group or sheet states, as its only number
/// with a unit of stress; empty if it states none.
std::optional<double> preshear_in_name(const std::string& name, const NumberStyle& style) {
    const auto found = stresses_in(name, style);
    if (found.size() != 1 || found[0].grouped_by_blanks || !speaks_of_preshear(name))
        return std::nullopt;
    const auto& readings = found[0].readings;
    return readings.size() == 1 ? std::optional(readings.front()) : std::nullopt;
}

/// Gives the points below a title such as "Pretaglio 3 kPa", or in a sheet of such a name, this
/// preshear. The title then names a level of consolidation, and no material.
void take_preshears_from_names(BlockFile& file) {
    const auto sheet = as_sheet(file.file);
    const auto of_sheet = sheet ? preshear_in_name(sheet->sheet, file.numbers) : std::nullopt;
    for (Block& block : file.blocks) {
        const auto of_group = preshear_in_name(block.group, file.numbers);
        block.preshear_normal_stress = of_group ? of_group : of_sheet;
        if (of_group) block.group.clear();
    }
}

bool of_one_test(const BlockFile& file) {
    return std::ranges::all_of(
        file.blocks, [&](const Block& block) { return block.test == file.blocks.front().test; });
}

/// Whether a row of the table is a preshear itself, or states one.
bool has_own_preshear(const Block& block) {
    return block.stated_role == "preshear" || block.preshear_normal_stress;
}

/// Normal stresses [Pa] that the preshear before these points may have: at least the largest load.
PossibleValues possible_preshears(const BlockFile& file) {
    constexpr double rounding = 0.95, usual = 100;  // a preshear of 100 times the loads is no test
    double largest = 0;
    for (const Block& block : file.blocks) {
        const Columns columns(block.table);
        for (const Row& row : block.table.rows)
            largest = std::max(largest, columns.value_if_any(row, "normal_stress").value_or(0));
    }
    return largest > 0 ? PossibleValues{rounding * largest, usual * largest} : PossibleValues{};
}

/// The only one of the readings of a stress that is possible; empty if several or none are.
std::optional<double> only_possible(const NamedStress& stress, const PossibleValues& possible) {
    std::optional<double> only;
    for (const double reading : stress.readings) {
        if (!(reading > 0) || reading < possible.least || reading > possible.most) continue;
        if (only) return std::nullopt;
        only = reading;
    }
    return only;
}

/// Whether the words before a stress name a shear stress.
bool names_shear(const std::string& before) {
    constexpr std::array<std::string_view, 12> words = {
        "shear",        "tau",      "τ",      "schubspannung", "scherspannung", "taupre",
        "cisaillement", "cortante", "taglio", "tangential",    "τpre",          "tangentiel"};
    return std::ranges::any_of(lower_case_words(before), [&](const std::string& word) {
        return std::ranges::find(words, word) != words.end();
    });
}

/// Whether a line states a preshear, by words or by symbols such as "sigma_pre".
bool states_preshear(const std::string& line) {
    constexpr std::array<std::string_view, 8> negations = {"no",    "without", "ohne", "sans",
                                                           "senza", "sin",     "kein", "not"};
    static const TextPattern symbol(R"((?:^|[^A-Za-z])(?:sigma|tau|σ|τ)[ _]?pre(?![A-Za-z]))");
    const std::vector<std::string> words = lower_case_words(line);
    const bool negated = std::ranges::any_of(words, [&](const std::string& word) {
        return std::ranges::find(negations, word) != negations.end();
    });
    return !negated && (speaks_of_preshear(line) || symbol.first(line));
}

/// Stresses of a preshear [Pa].
struct Preshear {
    std::optional<double> normal, shear;
    bool contradicted = false;  ///< whether there is another one
};

/// Keeps a stress; two that differ contradict each other.
void keep(std::optional<double>& kept, double stress, Preshear& preshear) {
    if (kept && *kept != stress) preshear.contradicted = true;
    kept = stress;
}

/// Takes the stresses of all lines. One without a word is a shear stress if it is too small for a
/// preshear.
Preshear preshear_of(const std::vector<NamedStress>& stresses, const PossibleValues& possible) {
    constexpr double least = 0.02, most = 1.5;  // of shear stress over normal stress
    Preshear preshear;
    std::vector<NamedStress> others;
    for (const NamedStress& stress : stresses) {
        const auto normal =
            names_shear(stress.before) ? std::nullopt : only_possible(stress, possible);
        if (normal)
            keep(preshear.normal, *normal, preshear);
        else
            others.push_back(stress);
    }
    if (!preshear.normal) return preshear;
    for (const NamedStress& stress : others)
        if (const auto shear =
                only_possible(stress, {least * *preshear.normal, most * *preshear.normal}))
            keep(preshear.shear, *shear, preshear);
    return preshear;
}

/// Line of a fact, with the unit behind a number that has none; empty if it states no preshear.
std::string line_of_preshear(const Fact& fact, const NumberStyle& style) {
    const HeaderCell key = parse_header_cell(fact.key);
    const std::string_view quantity = meaning_of_column(key.name, "").quantity;
    if (key.deviation()) return "";
    const bool title = fact.key.starts_with("title");
    std::string line = title ? fact.value : key.name + ": " + fact.value;
    const bool named = quantity == "preshear_stress" || quantity == "preshear_shear_stress";
    if (!named && !states_preshear(line)) return "";
    if (parse_number(rewritten(fact.value, style))) line += " " + key.unit;
    return quantity == "preshear_shear_stress" ? "shear " + line : line;
}

/// Stresses of a preshear that lines above the table state.
Preshear preshear_above(const BlockFile& file) {
    constexpr std::size_t longest = 300;  // a longer text is a description
    std::vector<NamedStress> stresses;
    for (const Fact& fact : file.facts) {
        if (fact.key.size() + fact.value.size() > longest) continue;
        const auto of_line = stresses_in(line_of_preshear(fact, file.numbers), file.numbers);
        stresses.insert(stresses.end(), of_line.begin(), of_line.end());
    }
    if (stresses.empty()) return {};
    const Preshear preshear = preshear_of(stresses, possible_preshears(file));
    return preshear.contradicted ? Preshear{} : preshear;
}

}  // namespace

void state_preshears(BlockFile& file) {
    for (Block& block : file.blocks) {
        if (block.preshear_normal_stress || !block.has_column("preshear_stress")) continue;
        const Columns columns(block.table);
        for (const Row& row : block.table.rows)
            if (const auto stress = columns.value_if_any(row, "preshear_stress");
                !block.preshear_normal_stress && stress != 0.0)
                block.preshear_normal_stress = stress;
    }
    if (!file.table_of_points || std::ranges::any_of(file.blocks, has_own_preshear)) return;
    take_preshears_from_names(file);
    if (!of_one_test(file) || std::ranges::any_of(file.blocks, has_own_preshear)) return;
    const Preshear preshear = preshear_above(file);
    if (!preshear.normal) return;
    for (Block& block : file.blocks) {
        block.preshear_normal_stress = preshear.normal;
        block.preshear_shear_stress = preshear.shear;
    }
}

}  // namespace pendular
