#pragma once

#include <string_view>

namespace pendular {

/// Quantity that a column of an instrument's file holds.
struct ColumnMeaning {
    std::string_view quantity;  ///< name of the quantity; empty if the program uses none
    int rank = 0;               ///< 0 for the most specific name of the quantity, then 1, 2
};

/// Quantity that a column of a rheometer's export holds, by its name and unit. Names are those of
/// RheoCompass, Rheoplus, TRIOS, rSpace and RheoWin in English, French and German, or any name that
/// `find_quantity` knows.
ColumnMeaning meaning_of_column(std::string_view name, std::string_view unit);

/// Quantity whose set points a column holds, by its name and unit: "normal_force" for "Normal Force
/// set" or "Normal Force (target) [N]"; empty for other columns.
std::string_view set_point_of(std::string_view name, std::string_view unit);

/// Whether a name is that of a column that counts the points of an interval, such as "Point No.".
bool counts_points(std::string_view name);

}  // namespace pendular
