#pragma once

#include <string_view>
#include <vector>

#include "data/files/formats/block_file.h"

namespace pendular {

/// Columns of one interval of a file as numbers in SI units, one element per row; NaN where a cell
/// is empty. Columns that the interval lacks are empty.
struct IntervalSeries {
    std::vector<int> line;                 ///< line of each row in the file, from 1
    std::vector<double> time;              ///< [s]
    std::vector<double> torque;            ///< [N m]
    std::vector<double> normal_force;      ///< [N]
    std::vector<double> height;            ///< gap [m]
    std::vector<double> angular_velocity;  ///< [rad/s]
    std::vector<double> shear_stress;      ///< [Pa]
    std::vector<double> normal_stress;     ///< [Pa]
    std::vector<double> shear_rate;        ///< [1/s]

    std::size_t size() const { return line.size(); }
    /// Column of a quantity by its name.
    const std::vector<double>& column(std::string_view quantity) const;
    /// Shear stress [Pa], or else torque [N m]; empty if the interval has neither.
    const std::vector<double>& shear() const {
        return shear_stress.empty() ? torque : shear_stress;
    }
    /// Normal stress [Pa], or else normal force [N]; empty if the interval has neither.
    const std::vector<double>& normal() const {
        return normal_stress.empty() ? normal_force : normal_stress;
    }
};

/// Names of the quantities that `IntervalSeries` has columns of.
const std::vector<std::string_view>& series_quantities();

/// Reads the columns of a block as numbers.
/// @throws InputError at a cell that is neither empty nor a number, and at a header cell whose unit
///         is missing or wrong
IntervalSeries series_of(const Block& block);

}  // namespace pendular
