#include "data/recordings/stated_sample.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
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
#include "data/recordings/stated_number.h"

namespace pendular {
namespace {

using Words = std::vector<std::string_view>;

/// Quantity of the beads with the names that headers give it.
struct SampleFact {
    const std::vector<std::string_view>& names;
    const char* unit;
    PossibleValues possible;
    Words of_another = {};  ///< words of a line that states another quantity
};

const std::vector<std::string_view> names_of_diameter = {"bead diameter",
                                                         "diameter of the beads",
                                                         "grain diameter",
                                                         "grain size",
                                                         "mean grain size",
                                                         "median grain size",
                                                         "mean particle size",
                                                         "median particle size",
                                                         "Korndurchmesser d50",
                                                         "bead diameter d50",
                                                         "grain diameter d50",
                                                         "grain size d50",
                                                         "particle size d50",
                                                         "particle diameter",
                                                         "particle size",
                                                         "sphere diameter",
                                                         "diamètre des billes",
                                                         "diamètre billes",
                                                         "diamètre des grains",
                                                         "diamètre des particules",
                                                         "taille des grains",
                                                         "Perlendurchmesser",
                                                         "Perldurchmesser",
                                                         "Kugeldurchmesser",
                                                         "Korndurchmesser",
                                                         "Partikeldurchmesser",
                                                         "Korngröße",
                                                         "diámetro de las esferas",
                                                         "diámetro de las perlas",
                                                         "diámetro de los granos",
                                                         "diámetro de las partículas",
                                                         "diámetro de partícula",
                                                         "diametro delle sfere",
                                                         "diametro sfere",
                                                         "diametro delle perle",
                                                         "diametro dei grani",
                                                         "diametro delle particelle"};

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
    "bead mass",          "mass of beads",     "mass of the beads",   "mass of grains",
    "sample mass",        "mass of sample",    "mass of the sample",  "masse des billes",
    "masse de billes",    "masse billes",      "masse des grains",    "masse de l'échantillon",
    "Kugelmasse",         "Perlenmasse",       "Masse der Kugeln",    "Masse der Perlen",
    "Probenmasse",        "Einwaage",          "masa de las esferas", "masa de las perlas",
    "masa de los granos", "masa de esferas",   "masa de la muestra",  "massa sfere",
    "massa delle sfere",  "massa delle perle", "massa dei grani",     "massa del campione"};

const std::vector<std::string_view> symbols_of_diameter = {"d", "d50", "d 50", "dp", "ds"};
const std::vector<std::string_view> symbols_of_density = {"rho", "ρ", "rho s", "ρs", "rho p", "ρp"};

const std::vector<std::string_view> names_of_tension = {
    "surface tension",     "surface tension of the liquid", "liquid surface tension",
    "Oberflächenspannung", "tension superficielle",         "tension de surface",
    "tensión superficial", "tensione superficiale"};

const std::vector<std::string_view> names_of_contact_angle = {
    "contact angle",      "wetting angle",      "Kontaktwinkel",
    "Randwinkel",         "Benetzungswinkel",   "angle de contact",
    "angle de mouillage", "ángulo de contacto", "angolo di contatto"};

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

/// Whether a word of a text begins with one of these.
bool has_word(std::string_view text, const Words& begins) {
    return std::ranges::any_of(lower_case_words(text), [&](const std::string& word) {
        return std::ranges::any_of(begins,
                                   [&](std::string_view begin) { return word.starts_with(begin); });
    });
}

/// Words of a line that speaks of grains with the pores between them.
const Words words_of_packing = {"loose",  "lose",    "bulk",    "tapp",    "pour",    "fill",
                                "pack",   "füll",    "fuell",   "schütt",  "schuett", "stampf",
                                "rüttel", "ruettel", "apparen", "aparen",  "tass",    "vrac",
                                "sfus",   "mucchio", "granel",  "compact", "compatt"};

/// Words of a line that speaks of grains with their liquid.
const Words words_of_wet = {"wet",  "moist",  "feucht", "nass",  "humid", "húmed",
                            "umid", "mouill", "bagnat", "mojad", "damp"};

/// First fact with one of the names whose value has the dimension of the unit.
std::optional<StatedValue> first_of(const BlockFile& file, const std::vector<StatedFact>& facts,
                                    const SampleFact& sought) {
    for (const StatedFact& fact : facts) {
        if (!is_among_names(fact.name, sought.names)) continue;
        auto value = positive_value(fact, sought.unit, sought.possible, file.numbers);
        if (!value || has_word(fact.whole, sought.of_another)) continue;
        if (!fact.remark.empty()) value->doubt = StatedDoubt::name;
        return value;
    }
    return std::nullopt;
}

/// Value with a name in doubt.
std::optional<StatedValue> in_doubt(std::optional<StatedValue> value) {
    if (value && value->doubt == StatedDoubt::none) value->doubt = StatedDoubt::name;
    return value;
}

/// The number that a text of digits, marks and blanks is, below a limit.
std::optional<double> only_number(const std::string& text, double most, const NumberStyle& style) {
    const auto number = stated_number(text, style);
    if (!number || number->range || !number->unit.empty()) return std::nullopt;
    std::vector<double> possible;
    for (const double reading : number->readings)
        if (reading <= most) possible.push_back(reading);
    return possible.size() == 1 ? std::optional(possible.front()) : std::nullopt;
}

/// Whether what stands behind a content makes it that of a part of a mixture: "60 % in water".
bool is_concentration(const std::string& behind) {
    constexpr std::array<std::string_view, 12> signs = {
        "in",       "en",     "dans",  "aqueous", "aq",     "sol",
        "solution", "lösung", "mixed", "dissous", "gelöst", "soluzione"};
    return std::ranges::any_of(lower_case_words(behind), [&](const std::string& word) {
        return std::ranges::find(signs, word) != signs.end();
    });
}

/// Liquid content in the text of a fact: a number alone, or one in per cent among words. What is
/// larger than 0.5 without a unit is in per cent: more would fill the pores of any packing.
std::optional<double> content_of(const StatedFact& fact, const NumberStyle& style) {
    static const TextPattern percent(R"((\d[\d.,' ]*\d|\d)\s*(?:%|vol\.?\s*-?%|wt\.?\s*-?%)(.*))");
    static const TextPattern alone(R"((\d[\d.,' ]*\d|\d)(?:\s*(?:v/v|w/w|-|1))?)");
    const std::string text(trimmed(fact.text));
    if (const auto found = percent.first(text)) {
        const auto value = is_concentration(found->parts[2])
                               ? std::nullopt
                               : only_number(found->parts[1], 100, style);
        return value ? std::optional(*value / 100) : std::nullopt;
    }
    const auto found = alone.whole(text);
    const auto value = found ? only_number(found->parts[1], 100, style) : std::nullopt;
    if (!value) return std::nullopt;
    return *value > 0.5 || fact.unit.ends_with('%') ? *value / 100 : *value;
}

/// Whether a text says by which of the two a content is meant.
bool names_basis(const std::string& text, const std::vector<std::string_view>& words) {
    const std::string lower = lower_case(text);
    return std::ranges::any_of(
        words, [&](std::string_view word) { return lower.find(word) != std::string::npos; });
}

/// Volume of liquid over that of grains, or of their masses, that no packing of beads holds: its
/// pores have at most 0.45/0.55 of the volume of the grains.
constexpr double most_content = 0.82;

std::optional<StatedLiquid> liquid_above(const BlockFile& file) {
    for (const StatedFact& fact : stated_facts(file)) {
        const bool mass = is_among_names(fact.name, names_by_mass);
        if (!mass && !is_among_names(fact.name, names_by_volume)) continue;
        const auto value = content_of(fact, file.numbers);
        if (!value || !(*value < most_content)) continue;
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
    // Powders to boulders, foamed polymers to platinum, and samples up to those of a large cell.
    const PossibleValues diameters{1e-8, 0.1}, densities{20, 25e3}, masses{1e-6, 1e3};
    StatedSample sample{
        .diameter = first_of(file, facts, {names_of_diameter, "m", diameters}),
        .density = first_of(file, facts, {names_of_density, "kg/m^3", densities, words_of_packing}),
        .mass = first_of(file, facts, {names_of_mass, "kg", masses, words_of_wet}),
        // Water has 0.073 N/m, mercury 0.49 N/m; a liquid that does not wet draws no bridges.
        .surface_tension = first_of(file, facts, {names_of_tension, "N/m", {1e-4, 1}}),
        .contact_angle = first_of(file, facts, {names_of_contact_angle, "rad", {0, M_PI}})};
    // A letter may be that of another quantity: of a gap, or of a packing.
    if (!sample.diameter)
        sample.diameter =
            in_doubt(first_of(file, facts, {symbols_of_diameter, "m", {diameters.least, 0.02}}));
    if (!sample.density)
        sample.density = in_doubt(
            first_of(file, facts, {symbols_of_density, "kg/m^3", densities, words_of_packing}));
    return sample;
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
