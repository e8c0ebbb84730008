#pragma once

#include <Eigen/Core>

namespace pendular {

/// Scatter that the user states in the table [scatter] of study.toml: relative standard deviations
/// [1] of the shear stress (index 0) and the solid fraction (index 1).
struct StatedScatter {
    Eigen::Vector2d step = Eigen::Vector2d::Zero();     ///< between repetitions of one step
    Eigen::Vector2d filling = Eigen::Vector2d::Zero();  ///< between fillings of the cell
};

}  // namespace pendular
