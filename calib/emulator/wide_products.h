#pragma once

#include <Eigen/Core>

namespace pendular {

/// Solves L X = B and returns X, for the lower triangle L (n x n) of `lower` and B (n x m). Uses
/// the instructions AVX2 and FMA if the processor has them.
Eigen::MatrixXd solve_lower(const Eigen::MatrixXd& lower, Eigen::MatrixXd right);

/// Returns A' B (m x k) for matrices A (n x m) and B (n x k). Uses the instructions AVX2 and FMA if
/// the processor has them.
Eigen::MatrixXd transposed_product(const Eigen::MatrixXd& a,
                                   const Eigen::Ref<const Eigen::MatrixXd>& b);

}  // namespace pendular
