#include "analysis/misfit/live_misfit.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <stdexcept>

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
    const auto root = root_of(measured.covariance + prediction.covariance);
    const Eigen::MatrixXd& jacobian = prediction.jacobian;
    const Eigen::MatrixXd weighted = root.solve(jacobian);  // Sigma^-1 J
    const Eigen::MatrixXd covariance =
        root_of(jacobian.transpose() * weighted)
            .solve(Eigen::MatrixXd::Identity(jacobian.cols(), jacobian.cols()));
    const Eigen::MatrixXd inverse =
        root.solve(Eigen::MatrixXd::Identity(jacobian.rows(), jacobian.rows()));
    const Eigen::MatrixXd projected = inverse - weighted * covariance * weighted.transpose();
    const Eigen::VectorXd pulled = projected * (measured.value - prediction.value);
    Eigen::MatrixXd result(static_cast<Eigen::Index>(fitted), 1 + jacobian.cols());
    for (Eigen::Index k = 0; k < result.rows(); ++k) {
        const Eigen::Vector2d pull = pulled.segment<2>(2 * k);
        const Eigen::Vector2d freed = projected.block<2, 2>(2 * k, 2 * k).inverse() * pull;
        result(k, 0) = pull.dot(freed);
        result.row(k).tail(jacobian.cols()) =
            -(covariance * weighted.middleRows(2 * k, 2).transpose() * freed).transpose();
    }
    return result;
}

}  // namespace pendular
