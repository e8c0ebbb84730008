#pragma once

#include <Eigen/Dense>

// Decompositions of matrices, and what solves with them, compiled once, in decompositions.cpp: in
// each chunk of files that uses one, they took one to three seconds. This header is among those
// that are compiled first (CMakeLists.txt): files of a target that uses these need no #include of
// it.
namespace pendular {

using ColumnPivotingQr = Eigen::ColPivHouseholderQR<Eigen::MatrixXd>;
using OrthogonalDecomposition = Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>;
using HouseholderQr = Eigen::HouseholderQR<Eigen::MatrixXd>;
using Cholesky = Eigen::LLT<Eigen::MatrixXd>;
using PivotingCholesky = Eigen::LDLT<Eigen::MatrixXd>;
using SymmetricEigenvalues = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>;

/// Returns an orthonormal basis of the columns of a matrix, as many as its rank or, without
/// pivoting, as it has columns: the first columns of Q.
Eigen::MatrixXd basis_of(const ColumnPivotingQr& decomposed);
Eigen::MatrixXd basis_of(const HouseholderQr& decomposed);

Eigen::MatrixXd pseudo_inverse(const OrthogonalDecomposition& decomposed);

}  // namespace pendular

// NOLINTBEGIN(bugprone-macro-parentheses): `what` is `template` or `extern template`.
#define PENDULAR_DECOMPOSITIONS(what)                                                           \
    what class Eigen::ColPivHouseholderQR<Eigen::MatrixXd>;                                     \
    what class Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd>;                         \
    what class Eigen::HouseholderQR<Eigen::MatrixXd>;                                           \
    what class Eigen::LLT<Eigen::MatrixXd>;                                                     \
    what class Eigen::LDLT<Eigen::MatrixXd>;                                                    \
    what class Eigen::PartialPivLU<Eigen::MatrixXd>;                                            \
    what class Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>;                                  \
    what void pendular::ColumnPivotingQr::_solve_impl(const Eigen::VectorXd&, Eigen::VectorXd&) \
        const;                                                                                  \
    what void pendular::OrthogonalDecomposition::_solve_impl(const Eigen::VectorXd&,            \
                                                             Eigen::VectorXd&) const;           \
    what void pendular::HouseholderQr::_solve_impl(const Eigen::VectorXd&, Eigen::VectorXd&)    \
        const;                                                                                  \
    what void pendular::Cholesky::_solve_impl(const Eigen::VectorXd&, Eigen::VectorXd&) const;  \
    what void pendular::Cholesky::_solve_impl(const Eigen::MatrixXd&, Eigen::MatrixXd&) const;  \
    what void pendular::PivotingCholesky::_solve_impl(const Eigen::VectorXd&, Eigen::VectorXd&) \
        const;                                                                                  \
    what pendular::Cholesky& pendular::Cholesky::compute(                                       \
        const Eigen::EigenBase<Eigen::MatrixXd>&);                                              \
    what pendular::PivotingCholesky& pendular::PivotingCholesky::compute(                       \
        const Eigen::EigenBase<Eigen::MatrixXd>&);                                              \
    what pendular::SymmetricEigenvalues& pendular::SymmetricEigenvalues::compute(               \
        const Eigen::EigenBase<Eigen::MatrixXd>&, int);

// NOLINTEND(bugprone-macro-parentheses)
PENDULAR_DECOMPOSITIONS(extern template)
