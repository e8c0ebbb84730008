#pragma once

#include <array>
#include <vector>

#include "data/reading.h"

namespace pendular {

/// Correlation [1] of a model's error at condition a with its error at condition b, if the error is
/// a smooth function of the condition:
///     k(a, b) = exp(-[ln(s22_a/s22_b)^2/L_s^2 + (sqrt I_a - sqrt I_b)^2/L_I^2
///                     + (sqrt w_a - sqrt w_b)^2/L_w^2]/2),
/// with the normal stress s22, inertial number I, liquid content w, L_s = ln 10, L_I = 0.1 and L_w
/// = 0.1: the error changes over a decade of normal stress, over inertial numbers that differ as 0
/// and 0.01, and over liquid contents that differ as 0 and 0.01. Squared exponential as in Kennedy
/// and O'Hagan, J. R. Stat. Soc. B 63 (2001) 425.
double discrepancy_correlation(const Condition& a, const Condition& b);

/// Adds `discrepancy`, the model's expected errors relative to the measured stress ratio and solid
/// fraction [1], in this order, to the errors of readings: to their covariances, and as errors of
/// known size that readings share, with the correlation `discrepancy_correlation`. Zeros leave the
/// readings unchanged.
void add_discrepancy(std::vector<Reading>& readings, const std::array<double, 2>& discrepancy);

}  // namespace pendular
