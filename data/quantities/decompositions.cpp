#include "data/quantities/decompositions.h"

PENDULAR_DECOMPOSITIONS(template)

namespace pendular {

Eigen::MatrixXd basis_of(const ColumnPivotingQr& decomposed) {
    return decomposed.householderQ() *
           Eigen::MatrixXd::Identity(decomposed.rows(), decomposed.rank());
}

Eigen::MatrixXd basis_of(const HouseholderQr& decomposed) {
    return decomposed.householderQ() *
           Eigen::MatrixXd::Identity(decomposed.rows(), decomposed.cols());
}

Eigen::MatrixXd pseudo_inverse(const OrthogonalDecomposition& decomposed) {
    return decomposed.pseudoInverse();
}

}  // namespace pendular
