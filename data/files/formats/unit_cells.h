#pragma once

#include "data/files/csv.h"

namespace pendular {

/// Whether a cell at the begin of a row says that the others are units, as programs for plots write
/// it: "Units", "Einheiten".
bool says_units(const Cell& cell);

/// Whether a row below the names of columns has their units and no numbers: in brackets, or bare
/// where at least one of them is that of the quantity named above it: "s", "mN m", "N". The 1 of a
/// quantity without dimension may stand among them, and a name that is merged over both rows.
bool is_unit_row(const Row& names, const Row& row);

/// Takes the units of a table from its first row, if that is one of units, into the header:
/// "torque [mN m]".
void take_unit_row(Table& table);

}  // namespace pendular
