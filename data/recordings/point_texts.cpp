#include "data/recordings/point_texts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "data/files/folded_name.h"
#include "data/quantities/number.h"
#include "data/recordings/point_roles.h"

namespace pendular {
namespace {

std::vector<std::string> cells_of(const Table& table, std::size_t column) {
    std::vector<std::string> texts;
    for (const Row& row : table.rows)
        texts.push_back(row.cells[column].text);
    return texts;
}

/// Texts of a column; empty if a cell has none.
std::vector<std::string> texts_in(const Table& table, std::size_t column) {
    std::vector<std::string> texts = cells_of(table, column);
    if (std::ranges::any_of(texts, &std::string::empty)) texts.clear();
    return texts;
}

bool any_number(const std::vector<std::string>& texts) {
    return std::ranges::any_of(texts, [](const std::string& text) { return is_number(text); });
}

/// Whether each text stands in at least three rows in succession, as "3 kPa" and "6 kPa" do.
bool stands_in_groups(const std::vector<std::string>& texts) {
    constexpr std::size_t fewest_rows = 3;  // of a line that is fitted
    std::set<std::string> known;
    for (std::size_t begin = 0; begin < texts.size();) {
        std::size_t end = begin;
        while (end < texts.size() && texts[end] == texts[begin])
            ++end;
        if (end - begin < fewest_rows || !known.insert(texts[begin]).second) return false;
        begin = end;
    }
    return known.size() > 1;
}

}  // namespace

bool names_tests(std::string_view name) {
    constexpr std::array names = {"test no",
                                  "versuch nr",
                                  "probe nr",
                                  "sample no",
                                  "material",
                                  "wall material",
                                  "wall",
                                  "sample",
                                  "sample name",
                                  "specimen",
                                  "powder",
                                  "test",
                                  "run",
                                  "series",
                                  "wandmaterial",
                                  "wand",
                                  "probe",
                                  "probenname",
                                  "pulver",
                                  "versuch",
                                  "échantillon",
                                  "matériau",
                                  "paroi",
                                  "poudre",
                                  "essai",
                                  "muestra",
                                  "pared",
                                  "polvo",
                                  "ensayo",
                                  "campione",
                                  "materiale",
                                  "parete",
                                  "polvere",
                                  "prova",
                                  "batch",
                                  "lot",
                                  "charge",
                                  "product",
                                  "produkt",
                                  "produit",
                                  "producto",
                                  "prodotto",
                                  "serie",
                                  "group",
                                  "gruppe",
                                  "groupe",
                                  "grupo",
                                  "gruppo",
                                  "yield locus",
                                  "locus",
                                  "fließort",
                                  "bulk solid",
                                  "schüttgut",
                                  "essai n°",
                                  "essai no",
                                  "prueba",
                                  "prueba n°",
                                  "ensayo n°",
                                  "prova n°",
                                  "prova n",
                                  "test n°",
                                  "level",
                                  "niveau",
                                  "nivel",
                                  "livello",
                                  "preshear level",
                                  "consolidation level",
                                  "niveau de consolidation",
                                  "niveau de précisaillement",
                                  "nivel de consolidación",
                                  "livello di consolidazione"};
    return is_among_names(folded_name(name), names);
}

namespace {

/// Whether a column has a content of water or another liquid that is no `liquid_content`: most are
/// masses of water over masses of dry or wet grains.
bool names_water_content(const BlockColumn& column) {
    constexpr std::array names = {"water content",
                                  "moisture content",
                                  "moisture",
                                  "gravimetric water content",
                                  "teneur en eau",
                                  "taux d'humidité",
                                  "taux de liquide",
                                  "taux d'eau",
                                  "teneur en humidité",
                                  "umidità",
                                  "contenuto d'acqua",
                                  "tenore d'acqua",
                                  "contenuto di acqua",
                                  "humedad",
                                  "contenido de agua",
                                  "contenido de humedad",
                                  "wassergehalt",
                                  "feuchte",
                                  "feuchtigkeit",
                                  "feuchtegehalt",
                                  "wasseranteil",
                                  "liquid volume",
                                  "volume de liquide",
                                  "saturation",
                                  "degree of saturation",
                                  "degré de saturation",
                                  "grado di saturazione",
                                  "grado de saturación",
                                  "sättigungsgrad",
                                  "volume of liquid",
                                  "added water",
                                  "watergehalte",
                                  "water",
                                  "added liquid",
                                  "liquid added",
                                  "wasser",
                                  "wassermenge",
                                  "wasserzugabe",
                                  "eau",
                                  "eau ajoutée",
                                  "agua",
                                  "agua añadida",
                                  "acqua",
                                  "acqua aggiunta"};
    return (column.name == "w" && column.unit == "%") ||
           is_among_names(folded_name(column.name), names);
}

}  // namespace

bool names_condition(const BlockColumn& column) {
    constexpr std::array names = {"diameter",
                                  "grain diameter",
                                  "bead diameter",
                                  "particle size",
                                  "bead size",
                                  "grain size",
                                  "diamètre",
                                  "diamètre des billes",
                                  "diamètre des grains",
                                  "diametro",
                                  "diámetro",
                                  "durchmesser",
                                  "korngröße",
                                  "temperature",
                                  "température",
                                  "temperatura",
                                  "messtemperatur",
                                  "relative humidity",
                                  "humidité relative",
                                  "humedad relativa",
                                  "umidità relativa",
                                  "relative luftfeuchte",
                                  "relative feuchte",
                                  "humidity",
                                  "humidité",
                                  "velocity",
                                  "speed",
                                  "vitesse",
                                  "velocidad",
                                  "velocità",
                                  "geschwindigkeit",
                                  "d",
                                  "d50",
                                  "liquid",
                                  "liquide",
                                  "líquido",
                                  "liquido",
                                  "flüssigkeit",
                                  "preshear",
                                  "précisaillement",
                                  "precizalla",
                                  "pretaglio",
                                  "rh",
                                  "hr"};
    return names_water_content(column) || names_preshear(column.name) ||
           is_among_names(folded_name(column.name), names);
}

namespace {

/// Whether each text stands at three or more different loads in succession: it is that of a sample,
/// even if no load recurs at another one.
bool stands_over_loads(const std::vector<std::string>& texts, const std::vector<double>& loads) {
    if (loads.size() != texts.size() || !stands_in_groups(texts)) return false;
    constexpr std::size_t fewest = 3;  // of a line that is fitted
    for (std::size_t begin = 0; begin < texts.size();) {
        std::size_t end = begin, different = 1;
        for (; end < texts.size() && texts[end] == texts[begin]; ++end)
            different += end > begin && !is_same_load(loads[end], loads[end - 1]);
        if (different < fewest) return false;
        begin = end;
    }
    return true;
}

/// Load of each row, a normal stress or force in the unit of its column; empty if no column or a
/// cell states none.
std::vector<double> loads_of(const Block& block) {
    const auto column = std::ranges::find_if(block.columns, [](const BlockColumn& each) {
        return each.quantity == "normal_stress" || each.quantity == "normal_force";
    });
    if (column == block.columns.end()) return {};
    std::vector<double> loads;
    for (const Row& row : block.table.rows) {
        const auto load =
            parse_number(row.cells[static_cast<std::size_t>(column - block.columns.begin())].text);
        if (!load) return {};
        loads.push_back(*load);
    }
    return loads;
}

/// Whether each text stands at two rows in succession, of which all first ones have one load, the
/// largest: it numbers preshears and the points after them.
bool numbers_pairs(const std::vector<std::string>& texts, const std::vector<double>& loads) {
    if (loads.size() < 4 || loads.size() % 2 != 0) return false;
    for (std::size_t i = 0; i < loads.size(); i += 2)
        if (texts[i] != texts[i + 1] || (i > 0 && texts[i] == texts[i - 1]) ||
            !is_same_load(loads[i], loads[0]) || !is_lower_load(loads[i + 1], loads[i]))
            return false;
    return true;
}

/// Whether each text has points of failure at two loads at least, through which a line can go: a
/// number of each filling or load has not.
bool tells_tests_apart(const std::vector<std::string>& texts, const std::vector<double>& loads,
                       const std::vector<std::string>& roles) {
    if (numbers_pairs(texts, loads)) return false;
    std::map<std::string, std::pair<double, double>> range;
    for (std::size_t i = 0; i < texts.size(); ++i) {
        if (loads.empty() || (!roles.empty() && !roles[i].empty())) continue;
        auto& [least, most] = range.try_emplace(texts[i], loads[i], loads[i]).first->second;
        least = std::min(least, loads[i]), most = std::max(most, loads[i]);
    }
    return range.size() > 1 && std::ranges::all_of(range, [](const auto& each) {
               return is_lower_load(each.second.first, each.second.second);
           });
}

/// Title above each row; empty where no titles part the rows.
std::vector<std::string> titles_above(const Table& table, std::vector<Title> titles) {
    std::ranges::sort(titles, {}, &Title::line);
    std::vector<std::string> texts;
    for (const Row& row : table.rows) {
        const auto next = std::ranges::upper_bound(titles, row.line, {}, &Title::line);
        texts.push_back(next == titles.begin() ? "" : std::prev(next)->text);
    }
    const bool parted = std::ranges::adjacent_find(texts, std::not_equal_to{}) != texts.end();
    return parted ? texts : std::vector<std::string>();
}

/// Loads at each text, preshears aside.
std::map<std::string, std::vector<double>> loads_by_text(const std::vector<std::string>& texts,
                                                         const std::vector<double>& loads,
                                                         const std::vector<std::string>& roles) {
    std::map<std::string, std::vector<double>> result;
    for (std::size_t i = 0; i < loads.size(); ++i) {
        if (!roles.empty() && !roles[i].empty()) continue;
        std::vector<double>& own = result[texts[i]];
        if (std::ranges::none_of(own, [&](double each) { return is_same_load(each, loads[i]); }))
            own.push_back(loads[i]);
    }
    return result;
}

/// Whether each text stands at `fewest` different loads at least, of which two stand at another
/// text too.
bool repeats_loads(const std::map<std::string, std::vector<double>>& loads, std::size_t fewest) {
    const auto shares = [](const std::vector<double>& own, const std::vector<double>& other) {
        return std::ranges::count_if(own, [&](double load) {
                   return std::ranges::any_of(
                       other, [&](double each) { return is_same_load(each, load); });
               }) > 1;
    };
    return loads.size() > 1 && std::ranges::all_of(loads, [&](const auto& own) {
               return own.second.size() >= fewest &&
                      std::ranges::any_of(loads, [&](const auto& other) {
                          return own.first != other.first && shares(own.second, other.second);
                      });
           });
}

/// Whether the same loads recur at different texts of a column within any of the tests.
bool recurs_within_tests(const std::vector<std::string>& texts, const std::vector<double>& loads,
                         const PointTexts& found) {
    constexpr std::size_t fewest = 3;  // of a line that is fitted
    std::set<std::string> tests(found.tests.begin(), found.tests.end());
    if (tests.empty()) tests.insert("");
    return std::ranges::any_of(tests, [&](const std::string& test) {
        std::vector<std::string> own_texts, own_roles;
        std::vector<double> own_loads;
        for (std::size_t i = 0; i < loads.size(); ++i) {
            if (!found.tests.empty() && found.tests[i] != test) continue;
            own_texts.push_back(texts[i]);
            own_loads.push_back(loads[i]);
            own_roles.push_back(found.roles.empty() ? "" : found.roles[i]);
        }
        return repeats_loads(loads_by_text(own_texts, own_loads, own_roles), fewest);
    });
}

/// Column of texts or numbers that no cell lacks.
struct Texts {
    const BlockColumn& column;
    std::vector<std::string> cells;
};

/// Texts of a column, with its name before answers such as "yes".
std::vector<std::string> named_texts(const BlockColumn& column, std::vector<std::string> texts) {
    if (std::ranges::all_of(texts, is_answer))
        for (std::string& text : texts)
            text = fmt::format("{} {}", column.name, text);
    return texts;
}

/// Parts the tests further by a condition such as "Temperature 20 °C".
void part_by(const Texts& condition, std::vector<std::string>& tests) {
    tests.resize(condition.cells.size());
    for (std::size_t i = 0; i < tests.size(); ++i) {
        if (!tests[i].empty()) tests[i] += ", ";
        tests[i] += condition.column.name + " " + condition.cells[i];
        if (!condition.column.unit.empty()) tests[i] += " " + condition.column.unit;
    }
}

/// Parts the tests by columns of conditions, and names the columns that may tell tests apart.
void look_for_conditions(const std::vector<Texts>& columns, const std::vector<double>& loads,
                         PointTexts& found) {
    for (const Texts& each : columns) {
        if (!each.column.set_point_of.empty()) continue;
        const bool recurs = recurs_within_tests(each.cells, loads, found);
        const bool water = found.tests.empty() && names_water_content(each.column) &&
                           tells_tests_apart(each.cells, loads, found.roles);
        const bool apart = recurs || (found.tests.empty() && stands_over_loads(each.cells, loads));
        if (water || (apart && names_condition(each.column)))
            part_by(each, found.tests);
        else if (recurs)
            found.doubtful.push_back(each.column.name);
    }
}

}  // namespace

PointTexts texts_of_points(const Block& block, const std::vector<Title>& titles) {
    PointTexts found;
    const std::vector<double> loads = loads_of(block);
    std::vector<Texts> others;
    for (std::size_t i = 0; i < block.columns.size(); ++i) {
        const BlockColumn& column = block.columns[i];
        if (!column.quantity.empty()) continue;
        std::vector<std::string> roles;
        if (found.roles.empty())
            roles = roles_in_column(column.name, cells_of(block.table, i), loads);
        if (!roles.empty())
            found.roles = std::move(roles);
        else if (std::vector<std::string> texts = texts_in(block.table, i); !texts.empty())
            others.push_back({column, std::move(texts)});
    }
    for (const auto& [column, texts] : others)
        if (found.tests.empty() &&
            ((names_tests(column.name) && tells_tests_apart(texts, loads, found.roles)) ||
             (!any_number(texts) && stands_in_groups(texts))))
            found.tests = named_texts(column, texts);
    if (found.tests.empty()) {
        std::vector<std::string> above = titles_above(block.table, titles);
        if (!above.empty() && tells_tests_apart(above, loads, found.roles))
            found.tests = std::move(above);
    }
    look_for_conditions(others, loads, found);
    return found;
}

}  // namespace pendular
