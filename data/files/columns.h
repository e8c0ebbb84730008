#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "data/files/column_names.h"
#include "data/files/csv.h"
#include "data/files/header_cell.h"
#include "data/quantities/quantity.h"

namespace pendular {

/// Largest numbers of digits among the numbers in a column of a table. Trailing zeros count: who
/// writes 300.0 knows the value to 0.1. Exponents do not.
struct Digits {
    int significant = 0;
    int decimals = 0;  ///< digits after the decimal mark
};

/// Returns the digits of a column's cells. Cells without digits are ignored.
Digits digits_of(const std::vector<std::string_view>& cells);

/// Returns the step to which a value was rounded, in the unit of its column: the place value of the
/// last decimal or of the last significant digit, whichever is larger; 0 for a value of 0 and for a
/// column without digits. Rounding to the step causes an error with the variance step^2/12.
double resolution_of(double value, const Digits& digits);

/// Values of a table in SI units, found by the name of a quantity such as "torque", in any order of
/// the columns.
/// - Header cells read as in `parse_header_cell`.
/// - One column states the error of a quantity: `name_se` its standard error, `name_u95` the half
///   width of an interval that covers 95 %, and `name_sd` beside `name_n` the standard deviation of
///   n single values, of which `name` is the mean. Without `name_n`, `name_sd` is a standard error.
///   If the header cell states no unit, the column `name` gives the unit.
/// - A column `inertial_number_diameter_density` is divided by sqrt(6/pi) and read as
///   `inertial_number`.
/// - A column `rotational_speed` is read as `angular_velocity`. A unit without an angle (1/min)
///   means turns per time.
///
/// A faulty header cell causes an error only when its column is requested, so that unused columns
/// may have any header. Every function with a parameter `name` then throws an InputError at the
/// header cell: the column's unit is missing, unknown or of the wrong dimension, or two columns
/// have the quantity. Functions that read a cell throw an InputError at the cell if its text is not
/// a finite number, or is too large for a measured value.
class Columns {
  public:
    /// @param table not copied; must outlive the Columns object
    explicit Columns(const Table& table);

    /// Whether the table has a column of a quantity.
    bool has(std::string_view name) const { return find(name, false) != nullptr; }

    /// Checks that the table has a column of a quantity.
    /// @throws InputError if the column is missing; the message lists the header cells of the table
    void require(std::string_view name) const;
    /// Returns which of two quantities the table has a column of.
    /// @throws InputError if the table has columns of both quantities or of neither
    std::string_view require_one_of(std::string_view first, std::string_view second) const;

    /// Returns the value of a quantity in a row, in SI units. The table must have its column
    /// (`require`).
    double value(const Row& row, std::string_view name) const;
    /// Returns the value of a quantity in a row, in SI units; empty if the column is missing or the
    /// cell is empty.
    std::optional<double> value_if_any(const Row& row, std::string_view name) const;
    /// Column `index` of the table, in which a number x is factor*x + offset in SI units.
    struct Conversion {
        std::size_t index;
        double factor, offset;
    };
    /// Returns how to read a quantity's column; empty if it is missing.
    std::optional<Conversion> conversion(std::string_view name) const;
    /// Returns the standard error of a quantity in a row, in SI units, from the column that states
    /// its error:
    ///     name_se, name_sd     name_sd/sqrt(name_n)     name_u95/1.96   (normal distribution)
    /// Empty if there is no such column, or its cell is empty.
    /// @throws InputError at the cell if it is not positive, or at the number of values if that is
    ///         not a whole number of at least 2
    std::optional<double> standard_error(const Row& row, std::string_view name) const;
    /// Checks that each column `name_n` has a column `name_sd` beside it.
    /// @throws InputError at the header cell of the first that has not
    void check_numbers_of_values() const;
    /// Returns the index of the column with the error of a quantity; empty if there is none.
    std::optional<std::size_t> place_of_error(std::string_view name) const;
    /// Returns the header cells of standard deviations without a number of values.
    std::vector<std::string> deviations_without_number() const;

    /// Returns the step to which a quantity was rounded in each row, in SI units, deduced from the
    /// number of digits in the file (`resolution_of`); 0 if the column is missing or the cell is
    /// empty.
    std::vector<double> resolutions(std::string_view name) const;

    /// Returns the position of the cell of a quantity in a row, or only the line of the row if the
    /// column is missing.
    Position at(const Row& row, std::string_view name) const;

    /// Returns the indices of the header cells whose names the program does not know.
    const std::vector<std::size_t>& unknown() const { return unknown_; }
    /// Returns the texts of the header cells that are not empty and whose columns are not used.
    /// @param used names of quantities, with "_sd" for their standard deviations
    std::vector<std::string> others(const std::vector<std::string_view>& used) const;

  private:
    struct Column {
        std::string_view name;  ///< of the quantity
        ErrorMark mark = ErrorMark::none;
        double factor = 1;
        double offset = 0;
        std::size_t index = 0;
        bool relative = false;   ///< whether the errors are fractions of their values
        std::string wrong = {};  ///< error message about the unit; empty: valid

        bool deviation() const { return mark != ErrorMark::none; }
    };
    /// Column `name_n`.
    struct NumberOfValues {
        std::string_view name;
        std::size_t index = 0;
    };

    void add(std::size_t index);
    std::string unit_of(const HeaderCell& cell, const Quantity& quantity) const;
    /// Line with the units of all columns; empty unless several lack theirs.
    std::string advice_on_units() const;
    const Column* find(std::string_view name, bool deviation) const;
    const NumberOfValues* number_of_values(std::string_view name) const;
    double values_in(const Row& row, const NumberOfValues& column) const;
    double number(const Row& row, const Column& column) const;
    /// Advice to name an unused column in the unit of a quantity; empty if there is none.
    std::string advice_on_unused(std::string_view name) const;
    [[noreturn]] void refuse_missing(std::string_view wanted, const std::string& advice) const;

    const Table& table_;
    std::vector<HeaderCell> cells_;  ///< of the header
    std::vector<Column> columns_;
    std::vector<NumberOfValues> numbers_;
    std::vector<std::size_t> unknown_;
};

}  // namespace pendular
