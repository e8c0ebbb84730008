#pragma once

#include <Eigen/Core>
#include <string>

#include "analysis/diagnosis/impact.h"

namespace pendular::made_up {

/// Returns one value as a vector.
inline Eigen::VectorXd one(double value) {
    return Eigen::VectorXd::Constant(1, value);
}

/// Returns the impact of an effect that lowers the friction by a tenth of its size.
/// @param interest size that matters; `size` is estimated with the standard error `error`
inline Impact impact(const std::string& name, double interest, double size, double error) {
    const auto shift = [](double at) { return Shift{at, one(-0.1 * at), one(-0.1 * at), {}}; };
    return {.name = name,
            .quantity = "coefficient",
            .unit = "1",
            .group = "instrument",
            .error = error,
            .at_interest = shift(interest),
            .at_estimate = shift(size),
            .above = shift(size + error),
            .below = shift(size - error)};
}

}  // namespace pendular::made_up
