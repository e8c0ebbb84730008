#pragma once

#include <string_view>
#include <vector>

#include "data/files/formats/block_file.h"

namespace pendular {

/// Columns of one interval of a file in SI units, with one element per row: NaN where the cell is
/// empty. A column that the file lacks is empty. The instrument computed stresses and shear rate.
struct IntervalSeries {
    std::vector<int> line;                 ///< in the file, from 1
    std::vector<double> time;              ///< [s]
    std::vector<double> torque;            ///< [N m]
    std::vector<double> normal_force;      ///< [N]
    std::vector<double> height;            ///< gap [m]
    std::vector<double> angular_velocity;  ///< [rad/s]
    std::vector<double> shear_stress;      ///< [Pa]
    std::vector<double> normal_stress;     ///< [Pa]
    std::vector<double> shear_rate;        ///< [1/s]

    std::size_t size() const { return line.size(); }
    /// Returns the column of a quantity, such as "torque"; empty if there is none.
    const std::vector<double>& column(std::string_view quantity) const;
    /// Returns the shear stress [Pa] or, if the file has none, the torque [N m].
    const std::vector<double>& shear() const {
        return shear_stress.empty() ? torque : shear_stress;
    }
    /// Returns the normal stress [Pa] or, if the file has none, the normal force [N].
    const std::vector<double>& normal() const {
        return normal_stress.empty() ? normal_force : normal_stress;
    }
};

/// Returns the names of the quantities of `IntervalSeries`: "time", "torque" and so on.
const std::vector<std::string_view>& series_quantities();

/// Returns the columns of an interval.
/// @throws InputError at a cell that is neither empty nor a number, and at a header cell whose unit
///         is missing or wrong
IntervalSeries series_of(const Block& block);

}  // namespace pendular
