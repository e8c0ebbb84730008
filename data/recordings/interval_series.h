#pragma once

#include <string_view>
#include <vector>

#include "data/files/formats/block_file.h"

namespace pendular {

/// Columns of one interval of a file (step of constant set points) as numbers in SI units, with one
/// element per row. An element is NaN if the cell of the file is empty. A column that the file
/// lacks is empty.
struct IntervalSeries {
    std::vector<int> line;                 ///< line of each row in the file, from 1
    std::vector<double> time;              ///< time of each row [s]
    std::vector<double> torque;            ///< torque on the lid in each row [N m]
    std::vector<double> normal_force;      ///< normal force on the lid in each row [N]
    std::vector<double> height;            ///< gap (height of the sample) in each row [m]
    std::vector<double> angular_velocity;  ///< angular velocity of the lid in each row [rad/s]
    /// Shear stress of each row [Pa], computed by the instrument.
    std::vector<double> shear_stress;
    /// Normal stress of each row [Pa], computed by the instrument.
    std::vector<double> normal_stress;
    /// Shear rate of each row [1/s], computed by the instrument.
    std::vector<double> shear_rate;

    std::size_t size() const { return line.size(); }
    /// Returns the column with the name of a quantity, such as "torque", in SI units. The column is
    /// empty if the file lacks the quantity, or if `IntervalSeries` has no column with the name.
    const std::vector<double>& column(std::string_view quantity) const;
    /// Returns the shear stress [Pa] of each row. If the file has no shear stress, the function
    /// returns the torque [N m] of each row. The column is empty if the file has neither.
    const std::vector<double>& shear() const {
        return shear_stress.empty() ? torque : shear_stress;
    }
    /// Returns the normal stress [Pa] of each row. If the file has no normal stress, the function
    /// returns the normal force [N] of each row. The column is empty if the file has neither.
    const std::vector<double>& normal() const {
        return normal_stress.empty() ? normal_force : normal_stress;
    }
};

/// Returns the names of the quantities for which `IntervalSeries` has a column: "time", "torque"
/// and so on.
const std::vector<std::string_view>& series_quantities();

/// Returns the columns of an interval as numbers in SI units, with NaN for empty cells.
/// @throws InputError at a cell that is neither empty nor a number, and at a header cell whose unit
///         is missing or wrong
IntervalSeries series_of(const Block& block);

}  // namespace pendular
