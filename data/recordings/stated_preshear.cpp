#include "data/recordings/stated_preshear.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "data/files/column_names.h"
#include "data/files/columns.h"
#include "data/files/header_cell.h"
#include "data/quantities/number.h"
#include "data/quantities/units.h"

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
            if (!block.preshear_normal_stress)
                block.preshear_normal_stress = columns.value_if_any(row, "preshear_stress");
    }
    if (!file.table_of_points || !of_one_test(file) ||
        std::ranges::any_of(file.blocks, has_own_preshear))
        return;
    const auto normal = stated_stress(file, "preshear_stress");
    const auto shear = stated_stress(file, "preshear_shear_stress");
    if (!normal || *normal < 0) return;
    for (Block& block : file.blocks) {
        block.preshear_normal_stress = normal;
        block.preshear_shear_stress = shear;
    }
}

}  // namespace pendular
