#pragma once

#include <Eigen/Core>

namespace pendular {

/// Scatter of an instrument as its user knows it, standard deviations relative to the value of
/// (shear stress, solid fraction) [1].
struct StatedScatter {
    Eigen::Vector2d step = Eigen::Vector2d::Zero();     ///< from one step to its repetition
    Eigen::Vector2d filling = Eigen::Vector2d::Zero();  ///< from one filling to the next
};

}  // namespace pendular
