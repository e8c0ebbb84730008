#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "data/reading.h"

namespace pendular {

/// Returns the correlation coefficient [1] between the errors of a model's predictions at two
/// conditions: half of their variance varies smoothly with the condition, half of it differs from
/// one condition to the next,
///     (exp(-d^2/2) + exp(-(10 d)^2/2))/2,
///     d^2 = ln(s22_a/s22_b)^2/L_s^2 + (sqrt I_a - sqrt I_b)^2/L_I^2
///           + (sqrt w_a - sqrt w_b)^2/L_w^2,
/// with the liquid content w, L_s = ln 10 and L_I = L_w = 0.1. The smooth part correlates by 0.61
/// between normal stresses that differ by a factor of 10, inertial numbers 0 and 0.01, and liquid
/// contents 0 and 0.01; the rest between normal stresses that differ by a quarter.
/// Source: squared exponential as in Kennedy and O'Hagan, J. R. Stat. Soc. B 63 (2001) 425.
double discrepancy_correlation(const Condition& a, const Condition& b);

/// Returns the covariance of a model's discrepancy, the error that is expected of the model's
/// predictions, in products of the units of `values`. Two entries i and k that are both shear
/// stresses or both solid fractions have the covariance
///     discrepancy^2 x discrepancy_correlation x values(i) values(k).
/// The errors of shear stress and solid fraction are uncorrelated.
/// @param values predicted shear stress [Pa] and solid fraction [1] of each condition in turn
/// @param discrepancy relative errors [1] of shear stress and solid fraction
Eigen::MatrixXd discrepancy_covariance(const std::vector<Condition>& conditions,
                                       const Eigen::VectorXd& values,
                                       const std::array<double, 2>& discrepancy);

}  // namespace pendular
