#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "data/files/formats/block_file.h"

namespace pendular {

/// Columns of a recording, or of one interval of a file, in SI units, with one element per row. A
/// column that the file lacks is empty. The instrument computed stresses and shear rate, which are
/// NaN where a cell is empty or no number.
struct IntervalSeries {
    std::vector<int> line;                    ///< in the file, from 1
    std::vector<double> time;                 ///< as recorded [s]
    std::vector<double> torque;               ///< [N m]
    std::vector<double> normal_force;         ///< [N], compression positive
    std::vector<double> height;               ///< gap [m]
    std::vector<double> angular_velocity;     ///< [rad/s]
    std::vector<double> interval = {};        ///< number of the interval
    std::vector<double> shear_stress = {};    ///< [Pa]
    std::vector<double> normal_stress = {};   ///< [Pa]
    std::vector<double> shear_rate = {};      ///< [1/s]
    std::vector<double> shear_velocity = {};  ///< of the lid at the mean radius [m/s]
    std::vector<double> lever_force = {};     ///< on the arm that holds the lid [N]

    std::size_t size() const { return line.size(); }
    /// Returns the column of a quantity, such as "torque"; empty if there is none.
    const std::vector<double>& column(std::string_view quantity) const;
    /// Returns the shear stress [Pa] or, if the file has none, the torque [N m] or, if it has
    /// neither, the force on a lever [N].
    const std::vector<double>& shear() const {
        return !shear_stress.empty() ? shear_stress : !torque.empty() ? torque : lever_force;
    }
    /// Returns the normal stress [Pa] or, if the file has none, the normal force [N].
    const std::vector<double>& normal() const {
        return normal_stress.empty() ? normal_force : normal_stress;
    }
    /// Returns the rows from `begin` to `end` - 1.
    IntervalSeries rows(std::size_t begin, std::size_t end) const;
    /// Removes the rows whose element of `marked` is true.
    void erase_rows(const std::vector<bool>& marked);
};

/// Column of `IntervalSeries`, by the name of its quantity.
struct SeriesColumn {
    std::string_view name;
    std::vector<double> IntervalSeries::*values;
};

/// Returns all columns of `IntervalSeries`, the one table of what is read from a recording.
std::span<const SeriesColumn> series_columns();

/// Returns the columns of an interval, in which an empty cell is NaN.
/// @throws InputError at a cell that is neither empty nor a number, and at a header cell whose unit
///         is missing or wrong
IntervalSeries series_of(const Block& block);

}  // namespace pendular
