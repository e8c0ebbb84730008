#pragma once

#include <string>
#include <string_view>

#include "data/quantities/quantity.h"

namespace pendular {

/// Quantity that a column of a rheometer's export contains.
struct ColumnMeaning {
    std::string_view quantity;  ///< `Quantity::name`; empty: the column is not used
    /// Order of preference among columns of one quantity, 0 for the most specific name.
    int rank = 0;
    /// Whether a table that is no export of an instrument may give the name to another quantity, as
    /// "Stress".
    bool shared = false;
};

/// Whether a unit can be that of a quantity; a missing unit can.
bool unit_fits(std::string_view unit, std::string_view quantity_name);

/// Why a unit that does not fit a quantity is none of it: the message of `Unit`, or
/// `wrong_dimension`.
std::string why_unit_is_wrong(std::string_view unit, std::string_view quantity_name);

/// Returns the quantity that a column of a table has by one of the program's own names
/// (`find_quantity`); null for none. A symbol such as φ or T whose unit is that of something else,
/// an angle or a temperature, is none; a word such as "Speed" stays, so that its unit is refused.
const Quantity* quantity_of_cell(std::string_view name, std::string_view unit);

/// Returns the quantity that a column of a rheometer's export contains, by the names that
/// RheoCompass, Rheoplus, TRIOS, rSpace and RheoWin use in English, French and German, by their
/// Spanish and Italian names, and by those that `find_quantity` knows. There is none if the name is
/// unknown or the unit does not fit; an empty unit fits every quantity.
ColumnMeaning meaning_of_column(std::string_view name, std::string_view unit);

/// Unit in which instruments usually record a quantity, such as "mN m" for "torque": a guess to be
/// corrected.
std::string_view usual_unit(std::string_view quantity_name);

/// Returns the quantity whose set points a column contains: "normal_force" for "Normal Force set"
/// or "Normal Force (target)"; empty for columns without set points.
std::string_view set_point_of(std::string_view name, std::string_view unit);

/// Whether a column name, such as "Point No.", is that of the numbers of the rows of an interval.
bool counts_points(std::string_view name);

}  // namespace pendular
