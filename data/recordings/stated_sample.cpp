#include "data/recordings/stated_sample.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "data/files/columns.h"
#include "data/files/folded_name.h"
#include "data/files/header_cell.h"
#include "data/files/text_pattern.h"
#include "data/input_error.h"
#include "data/quantities/number.h"

namespace pendular {
namespace {

/// First fact with one of these names whose value has the dimension of a unit.
std::optional<StatedValue> first_of(const BlockFile& file, const std::vector<StatedFact>& facts,
                                    const std::vector<std::string_view>& names, const char* unit) {
    for (const StatedFact& fact : facts) {
        if (!is_among_names(fact.name, names)) continue;
        if (const auto value = positive_value(fact, unit, file.numbers))
            return StatedValue{*value, fact.line, fact.key, fact.text};
    }
    return std::nullopt;
}

const std::vector<std::string_view> names_of_diameter = {
    "bead diameter",           "diameter of the beads",
    "grain diameter",          "grain size",
    "particle diameter",       "particle size",
    "sphere diameter",         "diamètre des billes",
    "diamètre billes",         "diamètre des grains",
    "diamètre des particules", "taille des grains",
    "Perlendurchmesser",       "Perldurchmesser",
    "Kugeldurchmesser",        "Korndurchmesser",
    "Partikeldurchmesser",     "Korngröße",
    "diámetro de las esferas", "diámetro de las perlas",
    "diámetro de los granos",  "diámetro de las partículas",
    "diámetro de partícula",   "diametro delle sfere",
    "diametro sfere",          "diametro delle perle",
    "diametro dei grani",      "diametro delle particelle"};

/// A density without a word for what has it is taken for that of the grains; one of the bed has its
/// own word.
const std::vector<std::string_view> names_of_density = {"density",
                                                        "grain density",
                                                        "bead density",
                                                        "particle density",
                                                        "solid density",
                                                        "true density",
                                                        "density of the beads",
                                                        "masse volumique",
                                                        "masse volumique des billes",
                                                        "masse volumique des grains",
                                                        "densité des billes",
                                                        "densité des grains",
                                                        "Dichte",
                                                        "Korndichte",
                                                        "Kugeldichte",
                                                        "Perlendichte",
                                                        "Feststoffdichte",
                                                        "Reindichte",
                                                        "densidad",
                                                        "densidad de las esferas",
                                                        "densidad de los granos",
                                                        "densidad de las partículas",
                                                        "densità",
                                                        "densità delle sfere",
                                                        "densità dei grani",
                                                        "massa volumica",
                                                        "densità delle particelle"};

const std::vector<std::string_view> names_of_mass = {
    "bead mass",           "mass of beads",
    "mass of the beads",   "mass of grains",
    "sample mass",         "masse des billes",
    "masse de billes",     "masse billes",
    "masse des grains",    "masse de l'échantillon",
    "Kugelmasse",          "Perlenmasse",
    "Masse der Kugeln",    "Masse der Perlen",
    "Probenmasse",         "Einwaage",
    "masa de las esferas", "masa de las perlas",
    "masa de los granos",  "masa de esferas",
    "masa de la muestra",  "massa sfere",
    "massa delle sfere",   "massa delle perle",
    "massa dei grani",     "massa del campione"};

const std::vector<std::string_view> names_by_volume = {"liquid content",
                                                       "liquid fraction",
                                                       "liquid volume fraction",
                                                       "volume fraction of liquid",
                                                       "liquid",
                                                       "Flüssigkeitsgehalt",
                                                       "Flüssigkeitsanteil",
                                                       "Volumenanteil der Flüssigkeit",
                                                       "Flüssigkeit",
                                                       "teneur en liquide",
                                                       "taux de liquide",
                                                       "fraction de liquide",
                                                       "fraction volumique de liquide",
                                                       "liquide",
                                                       "contenido de líquido",
                                                       "fracción de líquido",
                                                       "fracción volumétrica de líquido",
                                                       "líquido",
                                                       "contenuto di liquido",
                                                       "frazione di liquido",
                                                       "frazione volumetrica di liquido",
                                                       "frazione in volume di liquido"};

// The water content of soils and powders is a ratio of masses.
const std::vector<std::string_view> names_by_mass = {"water content",
                                                     "moisture content",
                                                     "water",
                                                     "Wassergehalt",
                                                     "Feuchtegehalt",
                                                     "Wasser",
                                                     "teneur en eau",
                                                     "eau",
                                                     "contenido de agua",
                                                     "contenido en agua",
                                                     "agua",
                                                     "contenuto d'acqua",
                                                     "contenuto di acqua",
                                                     "acqua"};

/// Liquid content in the text of a fact: a number alone, or one in per cent among words. What is
/// larger than 0.5 without a unit is in per cent: more would fill the pores of any packing.
std::optional<double> content_of(const StatedFact& fact, const NumberStyle& style) {
    static const TextPattern percent(R"((\d+(?:[.,]\d+)?)\s*(?:%|vol\.?\s*-?%|wt\.?\s*-?%))");
    static const TextPattern alone(R"((\d+(?:[.,]\d+)?)(?:\s*(?:v/v|w/w|-|1))?)");
    std::string text(trimmed(fact.text));
    const auto number = [&](const PatternMatch& match) {
        return parse_number(rewritten(match.parts[1], style));
    };
    if (const auto found = percent.first(text)) {
        const auto value = number(*found);
        return value ? std::optional(*value / 100) : std::nullopt;
    }
    const auto found = alone.whole(text);
    const auto value = found ? number(*found) : std::nullopt;
    if (!value) return std::nullopt;
    return *value > 0.5 || fact.unit.ends_with('%') ? *value / 100 : *value;
}

/// Whether a text says by which of the two a content is meant.
bool names_basis(const std::string& text, const std::vector<std::string_view>& words) {
    const std::string lower = lower_case(text);
    return std::ranges::any_of(
        words, [&](std::string_view word) { return lower.find(word) != std::string::npos; });
}

std::optional<StatedLiquid> liquid_above(const BlockFile& file) {
    for (const StatedFact& fact : stated_facts(file)) {
        const bool mass = is_among_names(fact.name, names_by_mass);
        if (!mass && !is_among_names(fact.name, names_by_volume)) continue;
        const auto value = content_of(fact, file.numbers);
        if (!value || !(*value < 1)) continue;
        const std::string all = fact.text + " " + fact.unit;
        const bool by_mass = names_basis(all, {"mass", "wt", "w/w", "gew", "peso"}) ||
                             (mass && !names_basis(all, {"vol", "v/v"}));
        return StatedLiquid{
            *value, by_mass,
            fmt::format("\"{}: {}\" in line {} of the file", fact.key, fact.text, fact.line)};
    }
    return std::nullopt;
}

/// @throws InputError at a row with another content than the rows before
void check_equal(double content, double first, const Table& table, const Row& row) {
    constexpr double rounding = 1e-3;  // relative; a content is known to less
    if (std::abs(content - first) <= rounding * std::max(std::abs(content), std::abs(first)))
        return;
    throw InputError({table.file, row.line},
                     fmt::format("the liquid content changes here from {:.4g} to {:.4g}, but a "
                                 "recording has one liquid content; write one file for each",
                                 first, content));
}

}  // namespace

StatedSample stated_sample(const BlockFile& file) {
    const std::vector<StatedFact> facts = stated_facts(file);
    return {first_of(file, facts, names_of_diameter, "m"),
            first_of(file, facts, names_of_density, "kg/m^3"),
            first_of(file, facts, names_of_mass, "kg")};
}

std::optional<StatedLiquid> liquid_in_column(const BlockFile& file) {
    std::optional<StatedLiquid> stated;
    for (const Block& block : file.blocks) {
        const auto column =
            std::ranges::find(block.columns, "liquid_content", &BlockColumn::quantity);
        if (column == block.columns.end()) continue;
        const Columns columns(block.table);
        for (const Row& row : block.table.rows) {
            const auto content = columns.value_if_any(row, "liquid_content");
            if (!content) continue;
            if (!stated) stated = {*content, false, fmt::format("the column '{}'", column->name)};
            check_equal(*content, stated->value, block.table, row);
        }
    }
    return stated;
}

std::optional<StatedLiquid> stated_liquid(const BlockFile& file) {
    // Each point of a table of points may have a content of its own.
    const auto column = file.table_of_points ? std::nullopt : liquid_in_column(file);
    return column ? column : liquid_above(file);
}

}  // namespace pendular
