#pragma once

#include <Eigen/Core>

namespace pendular {

/// Scatter of an instrument that the user states in the table [scatter] of study.toml: relative
/// standard deviations of shear stress and solid fraction [1].
struct StatedScatter {
    /// Relative standard deviations [1] of the shear stress (first element) and of the solid
    /// fraction (second element) between repetitions of one step of constant set points.
    Eigen::Vector2d step = Eigen::Vector2d::Zero();
    /// Relative standard deviations [1] of the shear stress (first element) and of the solid
    /// fraction (second element) between fillings of the cell.
    Eigen::Vector2d filling = Eigen::Vector2d::Zero();
};

}  // namespace pendular
