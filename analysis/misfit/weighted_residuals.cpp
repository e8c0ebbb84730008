#include "analysis/misfit/weighted_residuals.h"

#include <Eigen/Dense>
#include <stdexcept>

#include "data/quantities/decompositions.h"

namespace pendular {
namespace {

/// Lower triangular root of a covariance of whitened predictions [1]. Such a covariance has no
/// eigenvalue above 1, but may be singular, and rounding may make eigenvalues negative: slightly,
/// which a negligible variance mends, or more where the readings are nearly exact, so that
/// whitening loses digits. Negative eigenvalues then count as 0. The root of zero is zero.
Eigen::MatrixXd lower_root(const Eigen::MatrixXd& covariance) {
    if (covariance.isZero(0)) return covariance;
    Eigen::LLT<Eigen::MatrixXd> factor;
    for (const double variance : {1e-10, 1e-8, 1e-6}) {
        factor.compute(covariance +
                       variance * Eigen::MatrixXd::Identity(covariance.rows(), covariance.cols()));
        if (factor.info() == Eigen::Success) return factor.matrixL();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> parts(covariance);
    const Eigen::VectorXd sizes = parts.eigenvalues().cwiseMax(0).cwiseSqrt();
    const Eigen::MatrixXd root = parts.eigenvectors() * sizes.asDiagonal();
    // root root' = (QR)'(QR) = R'R
    const Eigen::MatrixXd upper = root.transpose().householderQr().matrixQR();
    return upper.triangularView<Eigen::Upper>().toDenseMatrix().transpose();
}

}  // namespace

WeightedResiduals::WeightedResiduals(const Measured& measured, const Prediction& prediction)
    : measured_(measured.value) {
    const Eigen::LLT<Eigen::MatrixXd> factor(measured.covariance + prediction.covariance);
    if (factor.info() != Eigen::Success) {
        throw std::logic_error("the covariance of the readings is not positive definite");
    }
    lower_ = factor.matrixL();
    prediction_root_ = lower_root(whiten(whiten(prediction.covariance).transpose()));
    residuals_ = whiten(measured.value - prediction.value);
    slopes_ = whiten(prediction.jacobian);
    // Columns of zeros are divided by a tiny length and stay zero; the rank does not count them.
    lengths_ = slopes_.colwise().norm().cwiseMax(1e-300);
    decomposed_.setThreshold(1e-7);
    decomposed_.compute(slopes_ * lengths_.cwiseInverse().asDiagonal());
    basis_ = basis_of(decomposed_);
}

double WeightedResiduals::log_determinant() const {
    return 2 * lower_.diagonal().array().log().sum();
}

Eigen::MatrixXd WeightedResiduals::whiten(const Eigen::MatrixXd& columns) const {
    return lower_.triangularView<Eigen::Lower>().solve(columns);
}

Eigen::MatrixXd WeightedResiduals::whiten_basis(const Eigen::MatrixXd& columns) const {
    return lower_.transpose().triangularView<Eigen::Upper>().solve(columns);
}

double WeightedResiduals::trace_of_projected(const Eigen::MatrixXd& covariance) const {
    // tr(P L^-1 C L^-T) = tr(C Sigma^-1) - tr(V' C V), with V = L^-T times the basis of J
    const Eigen::MatrixXd along = whiten_basis(basis_);
    std::call_once(inverse_->once, [&] {
        inverse_->matrix = whiten_basis(whiten(Eigen::MatrixXd::Identity(size(), size())));
    });
    return covariance.cwiseProduct(inverse_->matrix).sum() -
           (along.transpose() * covariance * along).trace();
}

double WeightedResiduals::variance_along(const Eigen::VectorXd& direction,
                                         const Eigen::MatrixXd& covariance) const {
    const Eigen::VectorXd along = whiten_basis(direction);
    return along.dot(covariance * along);
}

Eigen::MatrixXd WeightedResiduals::project(const Eigen::MatrixXd& columns) const {
    return columns - basis_ * (basis_.transpose() * columns);
}

Eigen::MatrixXd WeightedResiduals::means_over(
    const std::vector<std::vector<Eigen::Index>>& groups) const {
    Eigen::MatrixXd members =
        Eigen::MatrixXd::Zero(size(), static_cast<Eigen::Index>(groups.size()));
    for (std::size_t k = 0; k < groups.size(); ++k) {
        for (const Eigen::Index entry : groups[k]) {
            // A single reading is its own mean, even where it was measured as zero.
            members(entry, static_cast<Eigen::Index>(k)) =
                groups[k].size() == 1 ? 1 : measured_(entry);
        }
    }
    return project(basis_of(HouseholderQr(whiten(members))));
}

Eigen::VectorXd WeightedResiduals::parameter_shift_of(const Eigen::VectorXd& change) const {
    return lengths_.cwiseInverse().cwiseProduct(decomposed_.solve(change));
}

}  // namespace pendular
