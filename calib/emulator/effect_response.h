#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <vector>

namespace pendular {

/// Coordinates at which the response to an effect is asked: friction, sqrt(I), ln(1 + 10/P*), ln V0
/// and how far the effect goes, each of the order of 1 over the range of the studies.
using ResponsePlace = Eigen::Vector<double, 5>;

/// Change of an observable by an effect on grains, trained on the differences between runs with the
/// effect and the emulator's prediction of the same states without it:
///     change = b y(z, b),  b the effect's amplitude,
/// times 1/P* where it acts through capillary forces,
/// y a Gaussian process: a plane with coefficients hardly known plus a squared exponential. It
/// vanishes at neutral and is smooth there. Its two sizes have the greatest likelihood on a grid.
/// Source: Rasmussen and Williams, Gaussian Processes for Machine Learning (2006), section 2.7.
class EffectResponse {
  public:
    /// @param changes n, of the observable, and their n x n covariance
    /// @param amplitudes n, b of each
    EffectResponse(std::vector<ResponsePlace> places, Eigen::VectorXd amplitudes,
                   const Eigen::VectorXd& changes, const Eigen::MatrixXd& covariance);

    /// Changes at these places and amplitudes.
    Eigen::VectorXd mean(const std::vector<ResponsePlace>& at, const Eigen::VectorXd& b) const;
    /// Covariance of their errors.
    Eigen::MatrixXd covariance(const std::vector<ResponsePlace>& at,
                               const Eigen::VectorXd& b) const;

  private:
    double kernel(const ResponsePlace& a, const ResponsePlace& b) const;
    Eigen::MatrixXd kernels(const std::vector<ResponsePlace>& a, const Eigen::VectorXd& of_a,
                            const std::vector<ResponsePlace>& b, const Eigen::VectorXd& of_b) const;

    std::vector<ResponsePlace> places_;
    Eigen::VectorXd amplitudes_;
    double plane_ = 1, curved_ = 1;  ///< variances of plane and process
    Eigen::LLT<Eigen::MatrixXd> factor_;
    Eigen::VectorXd weights_;
};

}  // namespace pendular
