#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "data/files/csv.h"
#include "data/files/header_cell.h"
#include "data/quantities/quantity.h"

namespace pendular {

/// Access to the columns of a table by the names of their quantities, with numbers in SI units.
///
/// Header cells read `name [unit]`, `name (unit)` or `name in unit`; columns may be in any order. A
/// column `name_sd [unit]` holds standard deviations; without a unit of its own, it has the unit of
/// `name`. Two conventions are translated: `inertial_number_diameter_density`, rate a
/// sqrt(density/s22), is divided by sqrt(6/pi) and read as `inertial_number`; `rotational_speed`,
/// in turns unless the unit says otherwise, is read as `angular_velocity`.
class Columns {
  public:
    /// Matches the header cells to quantities and keeps a reference to the table. A faulty header
    /// cell raises an error only when its column is requested, so that unused columns may have any
    /// header.
    explicit Columns(const Table& table);

    /// Whether the table has a column of this quantity.
    /// @throws InputError at the header cell if the column's unit is missing, unknown or of the
    ///         wrong dimension, or if two columns have this quantity. All functions with a
    ///         parameter `name` throw this error.
    bool has(std::string_view name) const { return find(name, false) != nullptr; }

    /// Checks that the table has a column of this quantity.
    /// @throws InputError if the column is missing, listing the header cells of the table
    void require(std::string_view name) const;
    /// Name of the one quantity, `first` or `second`, of which the table has a column.
    /// @throws InputError if the table has columns of both quantities or of neither
    std::string_view require_one_of(std::string_view first, std::string_view second) const;

    /// Value of a quantity in a row, in SI units. The table must have a column of this quantity:
    /// call `require` first.
    /// @throws InputError at the cell if it is not a finite number
    double value(const Row& row, std::string_view name) const;
    /// Value of a quantity in a row, in SI units; empty if the table has no column of this quantity
    /// or the cell is empty.
    /// @throws InputError at the cell if its text is not a finite number
    std::optional<double> value_if_any(const Row& row, std::string_view name) const;
    /// Column that a quantity is read from: a number x in its cell `index`, from 0, is factor x +
    /// offset in SI units; empty if the table lacks the column.
    struct Conversion {
        std::size_t index;
        double factor, offset;
    };
    std::optional<Conversion> conversion(std::string_view name) const;
    /// Standard deviation of a quantity in a row, in SI units, from the column `name_sd`; empty if
    /// this column is missing or the cell is empty.
    /// @throws InputError at the cell if its text is not a positive number
    std::optional<double> deviation(const Row& row, std::string_view name) const;

    /// Rounding step of a quantity's value in each row, in SI units, from the digits in the file; 0
    /// if the column is missing or the cell is empty.
    std::vector<double> resolutions(std::string_view name) const;

    /// Position in the file of a row's cell in a quantity's column; if the table lacks the column,
    /// the line of the row.
    Position at(const Row& row, std::string_view name) const;

    /// Indices, from 0, of the header cells that name no quantity of the program.
    const std::vector<std::size_t>& unknown() const { return unknown_; }
    /// Texts of the non-empty header cells whose columns are not in `used`. `used` holds names of
    /// quantities ("torque"), with "_sd" for columns of standard deviations ("torque_sd").
    std::vector<std::string> others(const std::vector<std::string_view>& used) const;

  private:
    /// Column of a quantity; a number x in the column is factor x + offset in SI units.
    struct Column {
        std::string_view name;   ///< name of the quantity
        bool deviation = false;  ///< whether the column holds standard deviations
        double factor = 1;
        double offset = 0;
        std::size_t index = 0;   ///< place of the column in the table, from 0
        std::string wrong = {};  ///< error message about the column's unit; empty if there is none
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
