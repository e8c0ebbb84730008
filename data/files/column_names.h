#pragma once

#include <string>
#include <string_view>

namespace pendular {

/// Meaning of a column of errors, by the mark at the end of its name.
enum class ErrorMark {
    none,                ///< the column has values, not errors
    standard_error,      ///< "_se": standard error of the value
    standard_deviation,  ///< "_sd": beside "_n", of n single values; alone, a standard error
    half_width           ///< "_u95": half the width of an interval that covers 95 %
};

/// Parts of a header cell such as "Torque_sd [mN m]".
struct HeaderCell {
    std::string name;  ///< without a mark of errors: "Torque"
    std::string unit;  ///< "mN m"; empty if the cell gives none
    ErrorMark mark = ErrorMark::none;

    bool deviation() const { return mark != ErrorMark::none; }
};

/// Splits a header cell, which reads `name [unit]`, `name (unit)`, `name in unit`, `name / unit` or
/// `name`; where the unit is one of the named quantity, also `name/unit`, `name, unit` or
/// `name en unit`.
HeaderCell parse_header_cell(std::string_view text);

/// Quantity that a column of a rheometer's export contains.
struct ColumnMeaning {
    std::string_view quantity;  ///< `Quantity::name`; empty: the column is not used
    /// Order of preference among columns of one quantity, 0 for the most specific name.
    int rank = 0;
    /// Whether a table that is no export of an instrument may give the name to another quantity, as
    /// "Stress".
    bool shared = false;
};

/// Whether a text is a unit, such as "mN m"; an empty one is not.
bool is_unit(std::string_view text);

/// Whether a unit can be that of a quantity; a missing unit can.
bool unit_fits(std::string_view unit, std::string_view quantity_name);

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
