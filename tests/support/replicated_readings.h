#pragma once

#include <cmath>

#include "data/reading.h"

// Readings for tests on replicates and on stated errors.
namespace pendular::replicated {

/// Returns a dry reading at an inertial number of 0.01, whose errors of both quantities are
/// independent.
inline Reading reading(double normal_stress, double ratio, double fraction, double relative_error) {
    Reading result;
    result.condition = {normal_stress, 0.01, 0, std::nullopt};
    result.value = {ratio * normal_stress, fraction};
    const Eigen::Vector2d errors = relative_error * result.value;
    result.covariance = errors.cwiseProduct(errors).asDiagonal();
    return result;
}

/// Returns the relative variance [1] of the shear stress (0) or the solid fraction (1).
inline double relative_variance(const Reading& reading, int i) {
    return reading.covariance(i, i) / std::pow(reading.value(i), 2);
}

}  // namespace pendular::replicated
