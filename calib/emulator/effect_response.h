#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <vector>

#include "calib/emulator/bell_sums.h"

namespace pendular {

/// Point in five coordinates [1], each scaled to the order of 1, at which the change of an
/// observable by an effect on grains is evaluated. The coordinates follow, in turn, from
/// - the friction coefficient (coordinate x of `emulated::place_of`),
/// - sqrt(I) with the inertial number I,
/// - ln(1 + 10/P*) with the reduced pressure P*,
/// - ln(V0/a^3/0.002) with the bridge volume V0 and the grain diameter a (0 for dry grains),
/// - the amplitude of the effect.
using ResponsePlace = Eigen::Vector<double, 5>;

/// Predictor of how an effect on grains changes one observable. Each training value is the value in
/// a run with the effect minus the emulator's prediction without the effect. The predicted change
/// is
///     change = b p y(z, b),
/// with the coordinates z of the state and the amplitude b of the effect, which is 0 without the
/// effect. The factor p is 1/P*, with the reduced pressure P*, if the effect acts through capillary
/// forces and the observable is continuous in the dry limit (`Domain::all_flow`). Otherwise p = 1.
/// The function y is a Gaussian process: the sum of a plane (linear function of the coordinates)
/// and a process of squared exponential covariance. The variances of both parts maximise the
/// likelihood on a grid of values.
/// Source: Rasmussen and Williams, Gaussian Processes for Machine Learning (2006), section 2.7.
class EffectResponse {
  public:
    /// Trains the predictor on n observed changes of the observable by the effect.
    /// @param places coordinates at which each change was observed
    /// @param amplitudes product b p for each change, with the amplitude b of the effect and the
    ///        factor p of the class
    /// @param changes changes of the observable, divided by the scale of the observable
    ///        (`emulated::Unit::size`)
    /// @param covariance covariance (n x n) of the errors of `changes`
    EffectResponse(std::vector<ResponsePlace> places, Eigen::VectorXd amplitudes,
                   const Eigen::VectorXd& changes, const Eigen::MatrixXd& covariance);

    /// Returns the predicted change of the observable by the effect at each place of `at`, in the
    /// unit of the changes on which the predictor was trained.
    /// @param b product b p of the amplitude b of the effect and the factor p of the class, at each
    ///        place
    Eigen::VectorXd mean(const std::vector<ResponsePlace>& at, const Eigen::VectorXd& b) const;
    /// Returns the weights W [1] of the linear predictor mean(at, b) = W y, where y contains the
    /// changes of the observable that the effect caused in the training simulations. The matrix has
    /// one row for each place of `at` and one column for each element of y.
    Eigen::MatrixXd weights(const std::vector<ResponsePlace>& at, const Eigen::VectorXd& b) const;
    /// Returns the covariance of the errors of the changes that `mean` predicts for the arguments
    /// `at` and `b`, in the square of the unit of the training changes. The matrix has a row and a
    /// column for each place.
    Eigen::MatrixXd covariance(const std::vector<ResponsePlace>& at,
                               const Eigen::VectorXd& b) const;

  private:
    double kernel(const ResponsePlace& a, const ResponsePlace& b) const;
    Eigen::MatrixXd kernels(const std::vector<ResponsePlace>& a, const Eigen::VectorXd& of_a,
                            const std::vector<ResponsePlace>& b, const Eigen::VectorXd& of_b) const;

    std::vector<ResponsePlace> places_;
    Eigen::VectorXd amplitudes_;
    /// Prior variances of the two parts of the predictor: `plane_` for the plane (linear function
    /// of the coordinates), `curved_` for the process of squared exponential covariance. The unit
    /// is (unit of the changes/unit of b p)^2, with the amplitude b p of a change.
    double plane_ = 1, curved_ = 1;
    Eigen::LLT<Eigen::MatrixXd> factor_;
    /// Sums over the training changes, from which predictions follow: sum s (`plane_constant_`) and
    /// sum s z (`plane_slopes_`) for the plane, and a sum of Gaussian functions (bells) of weight s
    /// for the process (`bells_`). Here z contains the coordinates of a change, and
    ///     s = b (K + Sigma)^-1 changes,
    /// with the elements b of `amplitudes_`, the prior covariance K of the changes, and the
    /// covariance Sigma of the errors of the changes.
    double plane_constant_ = 0;
    ResponsePlace plane_slopes_ = ResponsePlace::Zero();
    BellSums bells_;
};

}  // namespace pendular
