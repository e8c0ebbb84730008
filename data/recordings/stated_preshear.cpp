#include "data/recordings/stated_preshear.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "data/files/column_names.h"
#include "data/files/columns.h"
#include "data/files/header_cell.h"
#include "data/files/sheet_path.h"
#include "data/files/text_pattern.h"
#include "data/quantities/number.h"
#include "data/quantities/units.h"
#include "data/recordings/point_roles.h"

namespace pendular {
namespace {

/// Stress [Pa] that a line above the table states of a quantity; empty if none does.
std::optional<double> stated_stress(const BlockFile& file, std::string_view quantity) {
    for (const Fact& fact : file.facts) {
        const HeaderCell key = parse_header_cell(fact.key);
        if (key.deviation() || meaning_of_column(key.name, "").quantity != quantity) continue;
        const std::size_t end = std::min(fact.value.find(' '), fact.value.size());
        std::string text =
            rewritten(fact.value.substr(0, end), file.numbers) + fact.value.substr(end);
        if (parse_number(text)) text += " " + key.unit;
        try {
            const double value = quantity_in_si(text, Unit("Pa"));
            if (std::isfinite(value) && value != 0) return value;
        } catch (const std::invalid_argument&) {  // a text, or a number without a unit
        }
    }
    return std::nullopt;
}

/// Whether a word of a text names a preshear: "Vorscherspannung 3 kPa", "pretaglio = 3 kPa".
bool speaks_of_preshear(std::string_view text) {
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find_first_of(" _:=,;()", begin), text.size());
        if (names_preshear(text.substr(begin, end - begin))) return true;
        begin = end + 1;
    }
    return false;
}

/// Normal stress [Pa] of the preshear that the name of a group or sheet states, as its only number
/// with a unit of stress; empty if it states none.
std::optional<double> preshear_in_name(const std::string& name) {
    static const TextPattern stress(
        R"((\d+(?:[.,]\d+)?)\s*(kPa|Pa|MPa|hPa|mbar|N/cm²|kN/m²)(?![A-Za-z]))");
    const auto found = stress.all(name);
    if (found.size() != 1 || !speaks_of_preshear(name)) return std::nullopt;
    std::string number = found[0].parts[1];
    std::ranges::replace(number, ',', '.');
    return quantity_in_si(number + " " + found[0].parts[2], Unit("Pa"));
}

/// Gives the points below a title such as "Pretaglio 3 kPa", or in a sheet of such a name, this
/// preshear. The title then names a level of consolidation, and no material.
void take_preshears_from_names(BlockFile& file) {
    const auto sheet = as_sheet(file.file);
    const auto of_sheet = sheet ? preshear_in_name(sheet->sheet) : std::nullopt;
    for (Block& block : file.blocks) {
        const auto of_group = preshear_in_name(block.group);
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
    const auto normal = stated_stress(file, "preshear_stress");
    const auto shear = stated_stress(file, "preshear_shear_stress");
    if (!normal || *normal < 0) return;
    for (Block& block : file.blocks) {
        block.preshear_normal_stress = normal;
        block.preshear_shear_stress = shear;
    }
}

}  // namespace pendular
