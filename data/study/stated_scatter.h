#pragma once

#include <Eigen/Core>

namespace pendular {

/// Scatter of an instrument as stated by its user: standard deviations relative to the values of
/// (shear stress, solid fraction) [1].
struct StatedScatter {
    /// Relative standard deviations between repetitions of one step, (shear stress, solid
    /// fraction).
    Eigen::Vector2d step = Eigen::Vector2d::Zero();
    /// Relative standard deviations between fillings of the cell, (shear stress, solid fraction).
    Eigen::Vector2d filling = Eigen::Vector2d::Zero();
};

}  // namespace pendular
