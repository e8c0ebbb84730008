#pragma once

#include <Eigen/Core>

namespace pendular {

/// Scatter of an instrument as stated by its user: standard deviations relative to the values of
/// (shear stress, solid fraction) [1].
struct StatedScatter {
    Eigen::Vector2d step = Eigen::Vector2d::Zero();     ///< scatter between repetitions of a step
    Eigen::Vector2d filling = Eigen::Vector2d::Zero();  ///< scatter between fillings of the cell
};

}  // namespace pendular
