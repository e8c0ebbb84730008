#include "data/recordings/point_texts.h"

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
    constexpr std::array names = {
        "test no",     "versuch nr", "probe nr",     "sample no",  "material", "wall material",
        "wall",        "sample",     "sample name",  "specimen",   "powder",   "test",
        "run",         "series",     "wandmaterial", "wand",       "probe",    "probenname",
        "pulver",      "versuch",    "échantillon",  "matériau",   "paroi",    "poudre",
        "essai",       "muestra",    "pared",        "polvo",      "ensayo",   "campione",
        "materiale",   "parete",     "polvere",      "prova",      "batch",    "lot",
        "charge",      "product",    "produkt",      "produit",    "producto", "prodotto",
        "serie",       "group",      "gruppe",       "groupe",     "grupo",    "gruppo",
        "yield locus", "locus",      "fließort",     "bulk solid", "schüttgut"};
    const std::string wanted = folded_name(name);
    return std::ranges::any_of(names,
                               [&](std::string_view each) { return folded_name(each) == wanted; });
}

namespace {

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

}  // namespace

PointTexts texts_of_points(const Block& block, const std::vector<Title>& titles) {
    PointTexts found;
    const std::vector<double> loads = loads_of(block);
    std::vector<std::pair<std::string, std::vector<std::string>>> others;
    for (std::size_t i = 0; i < block.columns.size(); ++i) {
        const BlockColumn& column = block.columns[i];
        if (!column.quantity.empty()) continue;
        std::vector<std::string> roles;
        if (found.roles.empty())
            roles = roles_in_column(column.name, cells_of(block.table, i), loads);
        if (!roles.empty())
            found.roles = std::move(roles);
        else if (std::vector<std::string> texts = texts_in(block.table, i); !texts.empty())
            others.emplace_back(column.name, std::move(texts));
    }
    for (const auto& [name, texts] : others)
        if (found.tests.empty() &&
            ((names_tests(name) && tells_tests_apart(texts, loads, found.roles)) ||
             (!any_number(texts) && stands_in_groups(texts))))
            found.tests = texts;
    if (!found.tests.empty()) return found;
    std::vector<std::string> above = titles_above(block.table, titles);
    if (!above.empty() && tells_tests_apart(above, loads, found.roles))
        found.tests = std::move(above);
    return found;
}

}  // namespace pendular
