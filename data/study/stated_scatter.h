#pragma once

#include <Eigen/Core>

namespace pendular {

/// Scatter of an instrument that the user states in [scatter] of study.toml: standard deviations
/// relative to the values of (shear stress, solid fraction) [1].
struct StatedScatter {
    /// Standard deviations between repetitions of one step, relative to the values of (shear
    /// stress, solid fraction) [1].
    Eigen::Vector2d step = Eigen::Vector2d::Zero();
    /// Standard deviations between fillings of the cell, relative to the values of (shear stress,
    /// solid fraction) [1].
    Eigen::Vector2d filling = Eigen::Vector2d::Zero();
};

}  // namespace pendular
