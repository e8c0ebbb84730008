#pragma once

#include <Eigen/Core>
#include <vector>

#include "calib/emulator/bell_sums.h"
#include "data/quantities/decompositions.h"

namespace pendular {

/// Point at which the change of an observable by an effect on grains is evaluated. The coordinates
/// [1], each scaled to the order of 1, follow in turn from
/// - the friction coefficient (coordinate x of `emulated::place_of`),
/// - sqrt(I), ln(1 + 10/P*) and ln(V0/a^3/0.002) (0 for dry grains),
/// - the amplitude of the effect.
using ResponsePlace = Eigen::Vector<double, 5>;

/// Predictor of how an effect on grains changes one observable. Each training value is the value in
/// a run with the effect minus the emulator's prediction without it. The predicted change is
///     change = b p y(z, b),
/// with the coordinates z of the state and the amplitude b of the effect, which is 0 without the
/// effect. The factor p is 1/P* if the effect acts through capillary forces and the observable is
/// continuous in the dry limit (`Domain::all_flow`), otherwise 1. The function y is a Gaussian
/// process: the sum of a plane (linear function of the coordinates) and a process of squared
/// exponential covariance. The variances of both parts maximise the likelihood on a grid of values.
/// Source: Rasmussen and Williams, Gaussian Processes for Machine Learning (2006), section 2.7.
class EffectResponse {
  public:
    /// Trains the predictor on n observed changes of the observable.
    /// @param amplitudes product b p of each change
    /// @param changes divided by the scale of the observable (`emulated::Unit::size`)
    /// @param covariance covariance (n x n) of the errors of `changes`
    EffectResponse(std::vector<ResponsePlace> places, Eigen::VectorXd amplitudes,
                   const Eigen::VectorXd& changes, const Eigen::MatrixXd& covariance);

    /// Returns the predicted change at each place of `at`, in the unit of the training changes.
    /// @param b product b p at each place
    Eigen::VectorXd mean(const std::vector<ResponsePlace>& at, const Eigen::VectorXd& b) const;
    /// Returns the weights W [1] of mean(at, b) = W `changes`, with a row for each place.
    Eigen::MatrixXd weights(const std::vector<ResponsePlace>& at, const Eigen::VectorXd& b) const;
    /// Returns the covariance of the errors of mean(at, b), in the unit of the changes squared.
    Eigen::MatrixXd covariance(const std::vector<ResponsePlace>& at,
                               const Eigen::VectorXd& b) const;

  private:
    double kernel(const ResponsePlace& a, const ResponsePlace& b) const;
    Eigen::MatrixXd kernels(const std::vector<ResponsePlace>& a, const Eigen::VectorXd& of_a,
                            const std::vector<ResponsePlace>& b, const Eigen::VectorXd& of_b) const;

    std::vector<ResponsePlace> places_;
    Eigen::VectorXd amplitudes_;
    /// Prior variances of the plane and of the process, in (unit of the changes/unit of b p)^2.
    double plane_ = 1, curved_ = 1;
    Eigen::LLT<Eigen::MatrixXd> factor_;
    /// Sums over the training changes, from which predictions follow: sum s and sum s z for the
    /// plane, and a sum of bells of weight s for the process, with the coordinates z of a change,
    ///     s = b (K + Sigma)^-1 changes,
    /// the elements b of `amplitudes_`, and the covariances K of the changes and Sigma of their
    /// errors.
    double plane_constant_ = 0;
    ResponsePlace plane_slopes_ = ResponsePlace::Zero();
    BellSums bells_;
};

}  // namespace pendular
