#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "data/files/csv.h"
#include "data/files/header_cell.h"
#include "data/quantities/quantity.h"

namespace pendular {

/// The columns of a table matched to known quantities, and their cells as numbers in SI units.
///
/// Header cells read `name [unit]`, `name (unit)` or `name in unit`, in any order; `name_sd [unit]`
/// holds standard deviations, in the unit of `name` if it has none of its own. Two conventions are
/// translated: `inertial_number_diameter_density`, rate a sqrt(density/s22), is divided by
/// sqrt(6/pi) and read as `inertial_number`; `rotational_speed` counts turns where its unit does
/// not say so, and is read as `angular_velocity`.
class Columns {
  public:
    /// Keeps a reference to the table. A faulty header cell raises an error only when its column is
    /// requested, so that unused columns may have any header.
    explicit Columns(const Table& table);

    /// @throws InputError, like all that follow, at the header cell for a unit that is none or of
    ///         the wrong dimension, and for two columns of one quantity
    bool has(std::string_view name) const { return find(name, false) != nullptr; }

    /// @throws InputError naming the column and those that were found, if it is not there
    void require(std::string_view name) const;
    /// Returns the one of two columns that the table has.
    /// @throws InputError if none or more than one is
    std::string_view require_one_of(std::string_view first, std::string_view second) const;

    /// Value of a required column's cell in SI units.
    /// @throws InputError at the cell if it is not a finite number
    double value(const Row& row, std::string_view name) const;
    /// Value in SI units; empty where the column is missing or the cell is empty.
    std::optional<double> value_if_any(const Row& row, std::string_view name) const;
    /// Standard deviation in SI units; empty where column or cell is.
    /// @throws InputError at the cell if it is not positive
    std::optional<double> deviation(const Row& row, std::string_view name) const;

    /// Step to which each row's value was rounded when it was written, in SI units; 0 where the
    /// column or a cell is not there.
    std::vector<double> resolutions(std::string_view name) const;

    /// Where the cell of a quantity stands; the row's beginning if there is no such column.
    Position at(const Row& row, std::string_view name) const;

    /// Header cells that name no known quantity.
    const std::vector<std::size_t>& unknown() const { return unknown_; }
    /// Header cells other than of the names given ("torque", "torque_sd"), as the file has them.
    std::vector<std::string> others(const std::vector<std::string_view>& used) const;

  private:
    struct Column {
        std::string_view name;
        bool deviation = false;
        double factor = 1;
        double offset = 0;
        std::size_t index = 0;
        std::string wrong = {};  ///< with its unit, if anything
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
