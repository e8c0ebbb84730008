#pragma once

#include <string_view>

namespace pendular {

/// Quantity that a column in the export of a rheometer measures.
struct ColumnMeaning {
    /// Name of the quantity that the column measures; empty if the program does not use the column.
    std::string_view quantity;
    /// Order of preference among the columns of a file that have the same quantity: 0 for the most
    /// specific column name, larger for less specific names.
    int rank = 0;
};

/// Returns the quantity that a column in the export of a rheometer measures, by its name and unit.
/// Known names are those of RheoCompass, Rheoplus, TRIOS, rSpace and RheoWin in English, French and
/// German, and all names that `find_quantity` knows. The unit must fit the quantity or be empty.
ColumnMeaning meaning_of_column(std::string_view name, std::string_view unit);

/// Returns the quantity whose set points a column has, by its name and unit: "normal_force" for
/// "Normal Force set" or "Normal Force (target) [N]"; empty for other columns.
std::string_view set_point_of(std::string_view name, std::string_view unit);

/// Whether a column with this name numbers the points of an interval, such as "Point No.".
bool counts_points(std::string_view name);

}  // namespace pendular
