#pragma once

#include <Eigen/Core>
#include <Eigen/QR>
#include <memory>
#include <mutex>
#include <vector>

#include "calib/fit/fit.h"

namespace pendular {

/// Residuals of a fit in units of their errors (whitened residuals r), with the projection P, which
/// removes from a change of the readings the part that a change of the calibrated parameters theta
/// can imitate:
///     r = L^-1 (y - f),   J = L^-1 df/dtheta,   P = I - J (J'J)^-1 J',
/// with the measured values y, the predictions f and the Cholesky factor L of the covariance L L' =
/// Sigma_measurement + Sigma_simulation. P ignores combinations of parameters that the readings do
/// not determine.
class WeightedResiduals {
  public:
    /// Computes the whitened residuals (in units of their errors) of the measured values from the
    /// prediction.
    /// @param prediction prediction of the measured values at the fitted parameters, with the
    ///        derivatives with respect to the parameters and the covariance of the simulation's
    ///        errors
    /// @throws std::logic_error if the covariance of measurement and prediction together is not
    ///         positive definite, or if the covariance of the prediction has negative eigenvalues
    WeightedResiduals(const Measured& measured, const Prediction& prediction);

    /// Returns the number of measured values: two for each reading, one for each direct measurement
    /// of an effect's parameter.
    Eigen::Index size() const { return residuals_.size(); }
    /// Returns the whitened residuals [1] of all measured values: L^-1 (measured - predicted), with
    /// the Cholesky factor L of the covariance of measurement and simulation.
    const Eigen::VectorXd& residuals() const { return residuals_; }
    /// Returns the measured values in the units of the readings, not whitened: shear stress and
    /// solid fraction of each reading in turn, then the direct measurements of effects' parameters.
    const Eigen::VectorXd& measured() const { return measured_; }
    /// Returns the chi2 of the fit [1]: squared norm of the whitened residuals.
    double chi2() const { return residuals_.squaredNorm(); }
    /// Returns the natural logarithm of the determinant of the covariance of measurement and
    /// simulation. The covariance is in products of the units of the readings.
    double log_determinant() const;

    /// Converts changes of the readings to units of the readings' errors (whitens): returns L^-1
    /// `columns`, with the Cholesky factor L of the covariance of measurement and simulation.
    /// @param columns changes in the units of the readings: a row for each measured value, a column
    ///        for each change
    Eigen::MatrixXd whiten(const Eigen::MatrixXd& columns) const;
    /// Returns L^-T `columns`, with the Cholesky factor L of the covariance of measurement and
    /// simulation. The scalar product of a returned column with a change in the units of the
    /// readings equals the scalar product of the column of `columns` with the whitened change.
    /// @param columns directions in units of the readings' errors (whitened): a row for each
    ///        measured value
    Eigen::MatrixXd whiten_basis(const Eigen::MatrixXd& columns) const;
    /// Returns the lower triangular root R of the whitened covariance of the prediction's errors
    /// [1]: R R' = L^-1 Sigma_simulation L^-T, with the Cholesky factor L of the covariance of
    /// measurement and simulation.
    const Eigen::MatrixXd& prediction_root() const { return prediction_root_; }
    /// Returns the expected squared norm [1] of the part of whitened errors that no change of the
    /// calibrated parameters can imitate: the trace of P L^-1 C L^-T, with the projection P and the
    /// Cholesky factor L of `WeightedResiduals`.
    /// @param covariance covariance C of the errors, in products of the units of the readings
    double trace_of_projected(const Eigen::MatrixXd& covariance) const;
    /// Returns the variance [1] of the component of whitened errors along a direction d: d' L^-1 C
    /// L^-T d, with the Cholesky factor L of the covariance of measurement and simulation.
    /// @param direction vector d in units of the readings' errors (whitened)
    /// @param covariance covariance C of the errors, in products of the units of the readings
    double variance_along(const Eigen::VectorXd& direction,
                          const Eigen::MatrixXd& covariance) const;
    /// Returns P `columns`: changes of the readings, in units of the readings' errors (whitened),
    /// without the part that a change of the calibrated parameters can imitate. P is the projection
    /// I - J (J'J)^-1 J' with the whitened derivatives J of the predictions.
    /// @param columns whitened changes: a row for each measured value, a column for each change
    Eigen::MatrixXd project(const Eigen::MatrixXd& columns) const;
    /// Returns the matrix P B, with the projection P of `WeightedResiduals` and a column for each
    /// group of measured values, such as the values at one condition. B is an orthonormal basis of
    /// the mean deviations of the groups, in units of the readings' errors (whitened). In a mean
    /// deviation, all values of a group deviate in proportion to their measured size.
    /// @param groups indices of the measured values of each group
    Eigen::MatrixXd means_over(const std::vector<std::vector<Eigen::Index>>& groups) const;
    /// Returns the change of the calibrated parameters [their units] that imitates a change of the
    /// predictions best, by least squares.
    /// @param change change of the predictions, in units of the readings' errors (whitened)
    Eigen::VectorXd parameter_shift_of(const Eigen::VectorXd& change) const;
    /// Returns the number of linearly independent combinations of the calibrated parameters that
    /// the readings determine.
    Eigen::Index determined() const { return basis_.cols(); }
    /// Returns the whitened derivatives L^-1 df/dtheta of the predictions f with respect to the
    /// calibrated parameters theta, with the Cholesky factor L of the covariance of measurement and
    /// simulation: a row for each measured value, a column for each parameter.
    const Eigen::MatrixXd& slopes() const { return slopes_; }

  private:
    Eigen::VectorXd measured_;
    /// Lower triangular Cholesky factor L of the covariance Sigma_measurement + Sigma_simulation of
    /// the errors of measurement and simulation.
    Eigen::MatrixXd lower_;
    Eigen::MatrixXd prediction_root_;
    /// Inverse of Sigma_measurement + Sigma_simulation, the covariance of measurement and
    /// simulation. The inverse is computed when it is first needed, and all copies of the object
    /// share the result.
    struct Inverse {
        std::once_flag once;
        Eigen::MatrixXd matrix;
    };
    std::shared_ptr<Inverse> inverse_ = std::make_shared<Inverse>();
    Eigen::VectorXd residuals_;
    Eigen::MatrixXd slopes_;
    /// Lengths (norms) of the columns of J, the whitened derivatives of the predictions.
    Eigen::VectorXd lengths_;
    /// QR decomposition of J, the whitened derivatives of the predictions, with each column divided
    /// by its entry of `lengths_`.
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> decomposed_;
    /// Orthonormal basis of the columns of J, the whitened derivatives of the predictions.
    Eigen::MatrixXd basis_;
};

}  // namespace pendular
