#pragma once

#include <Eigen/Core>

namespace pendular {

/// Scatter of an instrument that the user states in the table [scatter] of study.toml: standard
/// deviations of shear stress and solid fraction, divided by the value [1].
struct StatedScatter {
    /// Standard deviations between repetitions of one step, divided by the value [1]: first of the
    /// shear stress, second of the solid fraction.
    Eigen::Vector2d step = Eigen::Vector2d::Zero();
    /// Standard deviations between fillings of the cell, divided by the value [1]: first of the
    /// shear stress, second of the solid fraction.
    Eigen::Vector2d filling = Eigen::Vector2d::Zero();
};

}  // namespace pendular
