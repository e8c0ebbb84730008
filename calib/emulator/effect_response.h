#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <vector>

#include "calib/emulator/bell_sums.h"

namespace pendular {

/// Coordinates at which the change of an observable by an effect on grains is evaluated: the
/// emulator's coordinate x of friction (`emulated::place_of`), sqrt(I), ln(1 + 10/P*), ln V0 and
/// the amplitude of the effect, each scaled to the order of 1 over the range of usual studies. I:
/// inertial number; P*: reduced pressure; V0: bridge volume.
using ResponsePlace = Eigen::Vector<double, 5>;

/// Predictor of how an effect on grains changes one observable. It is trained on the differences
/// between runs with the effect and the emulator's predictions of the same states of steady shear
/// without the effect:
///     change = b y(z, b),
/// with the state z and the amplitude b of the effect, times 1/P* (P*: reduced pressure) if the
/// effect acts through capillary forces. y is a Gaussian process: the sum of a plane in the
/// coordinates and a process of squared exponential covariance. The change vanishes at the effect's
/// neutral value, b = 0, and is smooth near b = 0. Among a grid of values, the variances of plane
/// and process are those of the largest likelihood.
/// Source: Rasmussen and Williams, Gaussian Processes for Machine Learning (2006), section 2.7.
class EffectResponse {
  public:
    /// Trains the predictor on n observed changes of the observable by the effect.
    /// @param places coordinates of each change
    /// @param amplitudes amplitude b of the effect in each change, times 1/P* (P*: reduced
    ///        pressure) if the effect acts through capillary forces
    /// @param changes changes of the observable, divided by the scale of the observable
    ///        (`emulated::Unit::size`)
    /// @param covariance n x n covariance of the errors of `changes`
    EffectResponse(std::vector<ResponsePlace> places, Eigen::VectorXd amplitudes,
                   const Eigen::VectorXd& changes, const Eigen::MatrixXd& covariance);

    /// Predicts by how much the effect changes the observable at each place of `at`, in the unit of
    /// the changes on which the predictor was trained.
    /// @param b amplitude of the effect at each place, times 1/P* (P*: reduced pressure) if the
    ///        effect acts through capillary forces
    Eigen::VectorXd mean(const std::vector<ResponsePlace>& at, const Eigen::VectorXd& b) const;
    /// Weights W [1] with which the predictions of `mean` depend on the training changes y (changes
    /// of the observable by the effect): mean(at, b) = W y. A row for each place of `at`, a column
    /// for each training change.
    Eigen::MatrixXd weights(const std::vector<ResponsePlace>& at, const Eigen::VectorXd& b) const;
    /// Covariance of the errors of the changes that `mean` predicts for the arguments `at` and `b`:
    /// a row and a column for each place, in the squared unit of the training changes.
    Eigen::MatrixXd covariance(const std::vector<ResponsePlace>& at,
                               const Eigen::VectorXd& b) const;

  private:
    double kernel(const ResponsePlace& a, const ResponsePlace& b) const;
    Eigen::MatrixXd kernels(const std::vector<ResponsePlace>& a, const Eigen::VectorXd& of_a,
                            const std::vector<ResponsePlace>& b, const Eigen::VectorXd& of_b) const;

    std::vector<ResponsePlace> places_;
    Eigen::VectorXd amplitudes_;
    /// Prior variances of the two parts of the predictor: of the plane in the coordinates
    /// (`plane_`), and of the process of squared exponential covariance (`curved_`).
    double plane_ = 1, curved_ = 1;
    Eigen::LLT<Eigen::MatrixXd> factor_;
    /// Sums over the training changes from which predictions follow: sum s (`plane_constant_`) and
    /// sum s z (`plane_slopes_`) for the plane, and Gaussian functions (bells) of weight s for the
    /// process. s = b (K + Sigma)^-1 changes; b: amplitudes of the effect; z: coordinates; K: prior
    /// covariance of the changes; Sigma: covariance of their errors.
    double plane_constant_ = 0;
    ResponsePlace plane_slopes_ = ResponsePlace::Zero();
    BellSums bells_;
};

}  // namespace pendular
