#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <vector>

#include "calib/emulator/bell_sums.h"

namespace pendular {

/// Coordinates at which the response (change of an observable) to an effect on grains is evaluated:
/// the logarithmic coordinate of friction, sqrt(I), ln(1 + 10/P*), ln V0 (bridge volume) and the
/// amplitude of the effect, each scaled to the order of 1 over the range of the studies.
using ResponsePlace = Eigen::Vector<double, 5>;

/// Change of an observable by an effect on grains. It is trained on the differences between runs
/// with the effect and the emulator's predictions of the same flow states without the effect:
///     change = b y(z, b),  b the effect's amplitude,
/// times 1/P* where the effect acts through capillary forces. z is the flow state. y is a Gaussian
/// process, the sum of a plane in the coordinates and a process of squared exponential covariance.
/// The change vanishes at the effect's neutral value, where b = 0, and is smooth there. The
/// variances of plane and process are those of greatest likelihood on a grid.
/// Source: Rasmussen and Williams, Gaussian Processes for Machine Learning (2006), section 2.7.
class EffectResponse {
  public:
    /// Trains the response on n observed changes of the observable by the effect.
    /// @param places coordinates of each change
    /// @param amplitudes amplitude b of the effect in each change, times 1/P* where the effect acts
    ///         through capillary forces
    /// @param changes changes of the observable by the effect, in the unit of emulation
    ///         (`emulated::Unit`)
    /// @param covariance n x n covariance of the errors of `changes`
    EffectResponse(std::vector<ResponsePlace> places, Eigen::VectorXd amplitudes,
                   const Eigen::VectorXd& changes, const Eigen::MatrixXd& covariance);

    /// Predicted changes of the observable at places `at` with effect amplitudes `b`, one for each
    /// place, in the unit of the changes given for training.
    Eigen::VectorXd mean(const std::vector<ResponsePlace>& at, const Eigen::VectorXd& b) const;
    /// Weights of the training changes in the changes that `mean` predicts for the same arguments
    /// [1]: mean = weights x changes, a row for each place and a column for each training change.
    Eigen::MatrixXd weights(const std::vector<ResponsePlace>& at, const Eigen::VectorXd& b) const;
    /// Covariance of the errors of the changes that `mean` predicts for the same arguments.
    Eigen::MatrixXd covariance(const std::vector<ResponsePlace>& at,
                               const Eigen::VectorXd& b) const;

  private:
    double kernel(const ResponsePlace& a, const ResponsePlace& b) const;
    Eigen::MatrixXd kernels(const std::vector<ResponsePlace>& a, const Eigen::VectorXd& of_a,
                            const std::vector<ResponsePlace>& b, const Eigen::VectorXd& of_b) const;

    std::vector<ResponsePlace> places_;
    Eigen::VectorXd amplitudes_;
    double plane_ = 1, curved_ = 1;  ///< prior variances of the plane and of the other process
    Eigen::LLT<Eigen::MatrixXd> factor_;
    /// Weights s = b (K + Sigma)^-1 x training changes, with the amplitudes b, at the training
    /// places z: of the plane, sum s and sum s z, and of the process.
    double plane_constant_ = 0;
    ResponsePlace plane_slopes_ = ResponsePlace::Zero();
    BellSums bells_;
};

}  // namespace pendular
