#include "data/recordings/point_texts.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "data/files/folded_name.h"
#include "data/quantities/number.h"

namespace pendular {
namespace {

/// Texts of a column; empty if a cell has none.
std::vector<std::string> texts_in(const Table& table, std::size_t column) {
    std::vector<std::string> texts;
    for (const Row& row : table.rows) {
        if (row.cells[column].text.empty()) return {};
        texts.push_back(row.cells[column].text);
    }
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

bool names_preshear(std::string_view text) {
    constexpr std::array<std::string_view, 8> begins = {"preshear", "anscher",  "vorscher",
                                                        "precisai", "precizal", "pretagl",
                                                        "consolid", "konsolid"};
    const std::string word = folded_name(text);
    return std::ranges::any_of(begins,
                               [&](std::string_view each) { return word.starts_with(each); });
}

bool names_tests(std::string_view name) {
    constexpr std::array names = {
        "test no",   "versuch nr", "probe nr",     "sample no", "material", "wall material",
        "wall",      "sample",     "sample name",  "specimen",  "powder",   "test",
        "run",       "series",     "wandmaterial", "wand",      "probe",    "probenname",
        "pulver",    "versuch",    "échantillon",  "matériau",  "paroi",    "poudre",
        "essai",     "muestra",    "pared",        "polvo",     "ensayo",   "campione",
        "materiale", "parete",     "polvere",      "prova"};
    const std::string wanted = folded_name(name);
    return std::ranges::any_of(names,
                               [&](std::string_view each) { return folded_name(each) == wanted; });
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

/// Whether each text has points of failure at two loads at least, through which a line can go: a
/// number of each filling or load has not.
bool tells_tests_apart(const std::vector<std::string>& texts, const std::vector<double>& loads,
                       const std::vector<bool>& preshears) {
    constexpr double other_load = 0.05;  // relative: loads that are set differ by more
    std::map<std::string, std::pair<double, double>> range;
    for (std::size_t i = 0; i < texts.size(); ++i) {
        if (loads.empty() || (!preshears.empty() && preshears[i])) continue;
        auto& [least, most] = range.try_emplace(texts[i], loads[i], loads[i]).first->second;
        least = std::min(least, loads[i]), most = std::max(most, loads[i]);
    }
    return range.size() > 1 && std::ranges::all_of(range, [](const auto& each) {
               return each.second.second - each.second.first > other_load * each.second.second;
           });
}

}  // namespace

PointTexts texts_of_points(const Block& block) {
    PointTexts found;
    std::vector<std::pair<std::string, std::vector<std::string>>> others;
    for (std::size_t i = 0; i < block.columns.size(); ++i) {
        if (!block.columns[i].quantity.empty()) continue;
        const std::vector<std::string> texts = texts_in(block.table, i);
        if (texts.empty()) continue;
        const auto preshears = std::ranges::count_if(texts, names_preshear);
        if (preshears > 0 && preshears < std::ssize(texts) && found.preshears.empty())
            for (const std::string& text : texts)
                found.preshears.push_back(names_preshear(text));
        else
            others.emplace_back(block.columns[i].name, texts);
    }
    const std::vector<double> loads = loads_of(block);
    for (const auto& [name, texts] : others)
        if (found.tests.empty() &&
            ((names_tests(name) && tells_tests_apart(texts, loads, found.preshears)) ||
             (!any_number(texts) && stands_in_groups(texts))))
            found.tests = texts;
    return found;
}

}  // namespace pendular
