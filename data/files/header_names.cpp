#include "data/files/header_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "data/files/column_names.h"
#include "data/files/folded_name.h"
#include "data/files/header_cell.h"
#include "data/quantities/units.h"

namespace pendular {

bool is_relative_error(const HeaderCell& cell, const Quantity& quantity) {
    if (!(cell.deviation() || bare_mark(cell) != ErrorMark::none) || quantity.unit.empty())
        return false;
    const Unit number("1");
    return is_unit(cell.unit) && Unit(cell.unit).same_dimension(number) &&
           !Unit(quantity.unit).same_dimension(number);
}

std::string_view read_as(const Quantity& quantity) {
    if (quantity.name == "inertial_number_diameter_density") return "inertial_number";
    if (quantity.name == "rotational_speed") return "angular_velocity";
    return quantity.name;
}

namespace {

/// Quantity that says the same as another of a table of readings, so that only one is read; empty
/// for others.
std::string_view alternative_to(std::string_view quantity) {
    constexpr std::pair<std::string_view, std::string_view> all[] = {
        {"shear_stress", "stress_ratio"}, {"solid_fraction", "bulk_density"}};
    for (const auto& [first, second] : all) {
        if (quantity == first) return second;
        if (quantity == second) return first;
    }
    return "";
}

/// Index of the values of which a column has the errors: those of its name or, for a bare mark, the
/// column before it. Empty for other columns.
std::optional<std::size_t> values_of_errors(const std::vector<HeaderCell>& cells, std::size_t i) {
    if (cells[i].deviation()) {
        const auto same = [&](const HeaderCell& each) {
            return !each.deviation() && each.name == cells[i].name;
        };
        const auto found = std::ranges::find_if(cells, same);
        if (found == cells.end()) return {};
        return static_cast<std::size_t>(found - cells.begin());
    }
    if (i == 0 || cells[i - 1].deviation() || bare_mark(cells[i]) == ErrorMark::none) return {};
    return i - 1;
}

/// Names errors as their values, which are named as quantities by now.
void name_errors(Row& header, const std::vector<HeaderCell>& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const auto values = values_of_errors(cells, i);
        if (!values || find_quantity(cells[i].name)) continue;
        const HeaderCell named = parse_header_cell(header.cells[*values].text);
        const Quantity* const quantity = find_quantity(named.name);
        const std::string& unit = cells[i].unit;
        if (!quantity || (!unit.empty() && !unit_fits(unit, quantity->name) &&
                          !is_relative_error(cells[i], *quantity)))
            continue;
        const ErrorMark mark = cells[i].deviation() ? cells[i].mark : bare_mark(cells[i]);
        header.cells[i].text = fmt::format("{}{}", named.name, suffix_of(mark));
        if (!unit.empty()) header.cells[i].text += fmt::format(" [{}]", unit);
        // "SD" and "n" beside it: that of n values.
        if (mark == ErrorMark::standard_deviation && i + 1 < cells.size() &&
            folded_name(cells[i + 1].name) == "n" && cells[i + 1].unit.empty())
            header.cells[i + 1].text = fmt::format("{}_n", named.name);
    }
}

/// Whether a column may count levels of consolidation, or mark preshears by "yes": without a unit,
/// its numbers are no stresses.
bool may_count_levels(std::string_view quantity, const HeaderCell& cell) {
    if (quantity != "preshear_stress" || !cell.unit.empty()) return false;
    const std::string name = folded_name(cell.name);
    constexpr std::string_view stresses[] = {"stress", "contrainte", "tension",  "sforzo", "charge",
                                             "load",   "esfuerzo",   "spannung", "last",   "sigma",
                                             "σ",      "carga",      "carico"};
    const auto contains = [&](std::string_view word) { return name.find(word) != name.npos; };
    return std::ranges::none_of(stresses, contains);
}

}  // namespace

void use_names_of_quantities(Row& header) {
    constexpr int behind_all = 1000;  // more names than a quantity has
    struct Best {
        std::size_t column = 0;
        int rank = 0;
        std::string text;
    };
    std::vector<HeaderCell> cells;
    std::set<std::string_view> known;  // by the program's own names
    for (const Cell& cell : header.cells) {
        const HeaderCell& parts = cells.emplace_back(parse_header_cell(cell.text));
        const Quantity* const quantity = quantity_of_cell(parts.name, parts.unit);
        if (quantity && !parts.deviation()) known.insert(read_as(*quantity));
    }
    std::map<std::string_view, Best> best;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const HeaderCell& cell = cells[i];
        if (cell.deviation() || quantity_of_cell(cell.name, cell.unit)) continue;
        const ColumnMeaning meaning = meaning_of_column(cell.name, cell.unit);
        // "n" without a unit may be anything.
        const bool symbol = cell.name.size() <= 2 && cell.unit.empty();
        if (meaning.quantity.empty() || meaning.shared || symbol ||
            may_count_levels(meaning.quantity, cell))
            continue;
        const std::string_view as = read_as(quantity(meaning.quantity));
        if (known.contains(as) || known.contains(alternative_to(as))) continue;
        // A column with a unit comes before all without; one without is no reason to refuse a table
        // that has the stress in its place.
        if (cell.unit.empty() && ((as == "torque" && known.contains("shear_stress")) ||
                                  (as == "normal_force" && known.contains("normal_stress"))))
            continue;
        const int rank = meaning.rank + (cell.unit.empty() ? behind_all : 0);
        const auto [place, added] = best.try_emplace(as);
        if (!added && place->second.rank <= rank) continue;
        place->second = {i, rank, std::string(meaning.quantity)};
        if (!cell.unit.empty()) place->second.text += fmt::format(" [{}]", cell.unit);
    }
    for (const std::string_view first : {"shear_stress", "solid_fraction"})
        if (best.contains(first)) best.erase(alternative_to(first));
    for (const auto& [quantity, named] : best)
        header.cells[named.column].text = named.text;
    name_errors(header, cells);
}

}  // namespace pendular
