#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "data/files/csv.h"
#include "data/files/header_cell.h"
#include "data/quantities/quantity.h"

namespace pendular {

/// Values of a table in SI units, found by the name of a quantity such as "torque". Columns may be
/// in any order.
/// - Header cells read `name [unit]`, `name (unit)` or `name in unit`.
/// - A column `name_sd [unit]` has standard deviations. If its header cell states no unit, the
///   column `name` gives the unit.
/// - A column `inertial_number_diameter_density` has the shear rate times d sqrt(density/s22), with
///   grain diameter d and normal stress s22. The column is divided by sqrt(6/pi) and read as
///   `inertial_number`.
/// - A column `rotational_speed` is read as `angular_velocity`. A unit without an angle (1/min)
///   means turns per time.
class Columns {
  public:
    /// Finds the quantity and the unit of each column from its header cell. The table is not copied
    /// and must outlive the Columns object. A faulty header cell causes an error only when its
    /// column is requested, so that unused columns may have any header.
    explicit Columns(const Table& table);

    /// Whether the table has a column of a given quantity, such as "torque".
    /// @throws InputError at the header cell if the column's unit is missing, unknown or of the
    ///         wrong dimension, or if two columns have the quantity. Every function of Columns with
    ///         a parameter `name` throws this error.
    bool has(std::string_view name) const { return find(name, false) != nullptr; }

    /// Checks that the table has a column of a quantity, such as "torque".
    /// @throws InputError if the column is missing; the message lists the header cells of the table
    void require(std::string_view name) const;
    /// Returns the name of the quantity of which the table has a column: `first` or `second`.
    /// @throws InputError if the table has columns of both quantities or of neither
    std::string_view require_one_of(std::string_view first, std::string_view second) const;

    /// Returns the value of a quantity in a row, in SI units. The table must have a column of the
    /// quantity, which the function `require` checks.
    /// @throws InputError at the cell if the cell is not a finite number, or is too large for a
    ///         measured value
    double value(const Row& row, std::string_view name) const;
    /// Returns the value of a quantity in a row, in SI units. The result is empty if the table has
    /// no column of the quantity or if the cell is empty.
    /// @throws InputError at the cell if its text is not a finite number, or is too large for a
    ///         measured value
    std::optional<double> value_if_any(const Row& row, std::string_view name) const;
    /// Conversion of the numbers in the column with the index `index`, from 0, to SI units. A
    /// number x becomes factor*x + offset.
    struct Conversion {
        std::size_t index;
        double factor, offset;
    };
    /// Returns the index of a quantity's column in the table, and the conversion of the numbers in
    /// the column to SI units. The result is empty if the table lacks the column.
    std::optional<Conversion> conversion(std::string_view name) const;
    /// Returns the standard deviation of a quantity in a row, in SI units, from the column
    /// `name_sd`. The result is empty if the column is missing or the cell is empty.
    /// @throws InputError at the cell if its text is not a positive number
    std::optional<double> deviation(const Row& row, std::string_view name) const;

    /// Returns the step to which a quantity was rounded in each row, in SI units, deduced from the
    /// number of digits in the file. The rounding step is 0 if the column is missing or the cell is
    /// empty.
    std::vector<double> resolutions(std::string_view name) const;

    /// Returns the position in the file (line and column) of the cell of a quantity in a row. If
    /// the table lacks the quantity's column, the position is the line of the row.
    Position at(const Row& row, std::string_view name) const;

    /// Returns the indices, from 0, of the table's header cells whose names the program does not
    /// know.
    const std::vector<std::size_t>& unknown() const { return unknown_; }
    /// Returns the texts of the header cells that are not empty and whose columns are not used.
    /// @param used names of the used quantities such as "torque", with "_sd" for their standard
    ///         deviations
    std::vector<std::string> others(const std::vector<std::string_view>& used) const;

  private:
    /// Column of a quantity in the table. A number x in the column is factor*x + offset in SI
    /// units.
    struct Column {
        std::string_view name;  ///< name of the quantity in the column
        /// Whether the column contains standard deviations of the quantity.
        bool deviation = false;
        double factor = 1;
        double offset = 0;
        std::size_t index = 0;  ///< index of the column in the table, from 0
        /// Error message about the column's unit. The message is empty if the unit is valid.
        std::string wrong = {};
    };

    void add(std::size_t index);
    std::string unit_of(const HeaderCell& cell, const Quantity& quantity) const;
    const Column* find(std::string_view name, bool deviation) const;
    double number(const Row& row, const Column& column) const;
    [[noreturn]] void refuse_missing(std::string_view wanted) const;

    const Table& table_;
    std::vector<Column> columns_;
    std::vector<std::size_t> unknown_;
};

}  // namespace pendular
