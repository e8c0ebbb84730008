#pragma once

#include <Eigen/Core>

namespace pendular {

/// Solves L X = B and returns X, for a lower triangular matrix L (n x n) and a matrix B (n x m).
/// Uses the instructions AVX2 and FMA if the processor has them.
/// @param lower matrix whose lower triangle is L; the elements above the diagonal are not read
/// @param right matrix B
Eigen::MatrixXd solve_lower(const Eigen::MatrixXd& lower, Eigen::MatrixXd right);

/// Returns A' B (m x k) for matrices A (n x m) and B (n x k). Uses the instructions AVX2 and FMA if
/// the processor has them.
Eigen::MatrixXd transposed_product(const Eigen::MatrixXd& a,
                                   const Eigen::Ref<const Eigen::MatrixXd>& b);

}  // namespace pendular
