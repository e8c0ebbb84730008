#pragma once

#include <string_view>

#include "data/files/csv.h"
#include "data/files/header_cell.h"
#include "data/quantities/quantity.h"

namespace pendular {

/// Whether the errors in a column are fractions of their values, such as "tau ± [%]": their unit is
/// a number, that of the quantity is not.
bool is_relative_error(const HeaderCell& cell, const Quantity& quantity);

/// Name of the quantity that a column is read as, since two conventions are converted.
std::string_view read_as(const Quantity& quantity);

/// Replaces names that instruments and people use, such as "Drehmoment [mNm]", by the names of
/// quantities (`meaning_of_column`): "torque [mNm]". A quantity that the header names by itself
/// (`find_quantity`) is left alone, a name of a stress ratio or a bulk density beside a shear
/// stress or a solid fraction (or the contrary, if the header names these itself) too, and of
/// several names of one quantity only the first in the order of preference is replaced. Errors go
/// with their values, by name or, for a bare mark such as "±", by standing behind them.
void use_names_of_quantities(Row& header);

}  // namespace pendular
