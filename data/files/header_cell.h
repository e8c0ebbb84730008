#pragma once

#include <string>
#include <string_view>

namespace pendular {

/// Meaning of a column of errors, by the mark in its name.
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

/// "_sd" and the like, which `parse_header_cell` takes off a name; empty for none.
std::string_view suffix_of(ErrorMark mark);

/// Mark of a cell that is nothing but a mark, such as "±" or "Fehler [Pa]": errors of the column
/// before it. Without a unit, "error" may be the code of a fault and is none.
ErrorMark bare_mark(const HeaderCell& cell);

/// Splits a header cell, which reads `name [unit]`, `name (unit)`, `name in unit`, `name / unit` or
/// `name`; where the unit is one of the named quantity, also `name/unit`, `name, unit` or
/// `name en unit`. Marks of errors stand at the end ("tau_sd", "tau ±") or, where the rest names a
/// quantity, at the beginning ("sd of tau", "u(tau)", "Fehler der Schubspannung").
HeaderCell parse_header_cell(std::string_view text);

/// Whether a name has a factor before or behind it, such as "1000 × Torque" and "Couple/10": the
/// numbers may have been multiplied by it, or are to be.
bool names_factor_of_numbers(std::string_view name);

/// Whether a text is a unit, such as "mN m"; an empty one is not.
bool is_unit(std::string_view text);

}  // namespace pendular
