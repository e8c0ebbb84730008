#pragma once

#include <string_view>

namespace pendular {

/// Quantity that a column contains in a file that the software of a rheometer exported.
struct ColumnMeaning {
    /// Name of the quantity that the column contains. The name is empty if the program does not use
    /// the column.
    std::string_view quantity;
    /// Order of preference among the columns of a file that contain one quantity: 0 for the most
    /// specific column name, larger for less specific names.
    int rank = 0;
};

/// Returns the quantity that a column contains in a file from the software of a rheometer, given
/// the name and unit of the column. The function knows the names that RheoCompass, Rheoplus, TRIOS,
/// rSpace and RheoWin use in English, French and German, and all names that `find_quantity` knows.
/// The result has no quantity if the name is not known or the unit does not fit the quantity. An
/// empty unit fits every quantity.
ColumnMeaning meaning_of_column(std::string_view name, std::string_view unit);

/// Returns the quantity whose set points a column contains, given the name and unit of the column.
/// The result is "normal_force" for "Normal Force set" or "Normal Force (target)". The result is
/// empty for columns without set points.
std::string_view set_point_of(std::string_view name, std::string_view unit);

/// Whether a column with a given name, such as "Point No.", contains the numbers of the points
/// (rows) of an interval.
bool counts_points(std::string_view name);

}  // namespace pendular
