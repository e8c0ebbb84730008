#include "analysis/misfit/weighted_residuals.h"

#include <Eigen/Dense>
#include <stdexcept>

namespace pendular {

WeightedResiduals::WeightedResiduals(const Measured& measured, const Prediction& prediction)
    : measured_(measured.value) {
    const Eigen::LLT<Eigen::MatrixXd> factor(measured.covariance + prediction.covariance);
    if (factor.info() != Eigen::Success) {
        throw std::logic_error("the covariance of the readings is not positive definite");
    }
    lower_ = factor.matrixL();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(
        whiten_covariance(prediction.covariance));
    prediction_root_ = modes.eigenvectors() *
                       modes.eigenvalues().cwiseMax(0).cwiseSqrt().asDiagonal() *
                       modes.eigenvectors().transpose();
    residuals_ = whiten(measured.value - prediction.value);
    slopes_ = whiten(prediction.jacobian);
    lengths_ = slopes_.colwise().norm().cwiseMax(1e-300);
    decomposed_.setThreshold(1e-7);
    decomposed_.compute(slopes_ * lengths_.cwiseInverse().asDiagonal());
    basis_ =
        decomposed_.householderQ() * Eigen::MatrixXd::Identity(slopes_.rows(), decomposed_.rank());
}

double WeightedResiduals::log_determinant() const {
    return 2 * lower_.diagonal().array().log().sum();
}

Eigen::MatrixXd WeightedResiduals::whiten(const Eigen::MatrixXd& columns) const {
    return lower_.triangularView<Eigen::Lower>().solve(columns);
}

Eigen::MatrixXd WeightedResiduals::unwhiten(const Eigen::MatrixXd& columns) const {
    return lower_.triangularView<Eigen::Lower>() * columns;
}

Eigen::MatrixXd WeightedResiduals::whiten_basis(const Eigen::MatrixXd& columns) const {
    return lower_.transpose().triangularView<Eigen::Upper>().solve(columns);
}

Eigen::MatrixXd WeightedResiduals::whiten_covariance(const Eigen::MatrixXd& covariance) const {
    return whiten(whiten(covariance).transpose());
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
    const Eigen::HouseholderQR<Eigen::MatrixXd> decomposed(whiten(members));
    return project(decomposed.householderQ() *
                   Eigen::MatrixXd::Identity(members.rows(), members.cols()));
}

Eigen::VectorXd WeightedResiduals::share_imitated_by(const Eigen::VectorXd& change) const {
    return lengths_.cwiseInverse().cwiseProduct(decomposed_.solve(change));
}

}  // namespace pendular
