#include "analysis/misfit/live_misfit.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/QR>
#include <stdexcept>

#include "data/quantities/decompositions.h"

namespace pendular {
namespace {

Eigen::LLT<Eigen::MatrixXd> root_of(const Eigen::MatrixXd& covariance) {
    Eigen::LLT<Eigen::MatrixXd> root(covariance);
    if (root.info() != Eigen::Success) {
        throw std::logic_error("the covariance of the readings is not positive definite");
    }
    return root;
}

}  // namespace

Eigen::MatrixXd chi2_form(const Measured& measured, const Eigen::MatrixXd& simulation_covariance,
                          const Response& response) {
    const Eigen::Index n = measured.value.size(), p = response.first.cols();
    Eigen::MatrixXd terms(n, 1 + p + response.second.cols());
    terms << measured.value - response.value, -response.first, -response.second;
    const auto root = root_of(measured.covariance + simulation_covariance);
    const Eigen::MatrixXd white = root.matrixL().solve(terms);
    return white.transpose() * white;
}

Eigen::MatrixXd without_each(const Measured& measured, const Prediction& prediction,
                             std::size_t fitted) {
    const Eigen::MatrixXd covariance = measured.covariance + prediction.covariance;
    const Eigen::MatrixXd white =
        root_of(covariance)
            .matrixL()
            .solve(Eigen::MatrixXd::Identity(covariance.rows(), covariance.cols()));
    const Eigen::MatrixXd slopes = white * prediction.jacobian;
    const Eigen::VectorXd norms = slopes.colwise().norm();
    const Eigen::VectorXd unit = (norms.array() > 0).select(norms.cwiseInverse(), 1.0);
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
    solver.setThreshold(1e-8);  // columns of length 1: less is rounding of the derivatives
    solver.compute(slopes * unit.asDiagonal());
    const Eigen::MatrixXd estimator = unit.asDiagonal() * (pseudo_inverse(solver) * white);
    const Eigen::MatrixXd projected = white.transpose() * (white - slopes * estimator);
    const Eigen::VectorXd pulled = projected * (measured.value - prediction.value);
    Eigen::MatrixXd result(static_cast<Eigen::Index>(fitted), 1 + slopes.cols());
    for (Eigen::Index k = 0; k < result.rows(); ++k) {
        const Eigen::Vector2d pull = pulled.segment<2>(2 * k);
        const Eigen::Vector2d freed = projected.block<2, 2>(2 * k, 2 * k).inverse() * pull;
        result(k, 0) = pull.dot(freed);
        result.row(k).tail(slopes.cols()) = -(estimator.middleCols(2 * k, 2) * freed).transpose();
    }
    return result;
}

}  // namespace pendular
