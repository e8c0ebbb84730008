#pragma once

#include <Eigen/Core>
#include <Eigen/QR>
#include <memory>
#include <mutex>
#include <vector>

#include "calib/fit/fit.h"

namespace pendular {

/// Whitened residuals r of a fit, in units of their errors, and the projection P that removes from
/// a change of the readings what a change of the calibrated parameters theta can imitate:
///     r = L^-1 (y - f),   J = L^-1 df/dtheta,   P = I - J (J'J)^-1 J',
/// y: measured values, f: predictions, L L' = Sigma_measurement + Sigma_simulation. P comes from a
/// QR decomposition and is never formed; combinations of parameters that the readings do not
/// determine remove nothing.
class WeightedResiduals {
  public:
    /// @param prediction prediction of the measured values at the fitted parameters, with its
    ///        derivatives by these parameters and its covariance from errors of the simulation
    /// @throws std::logic_error where the covariance of measurement and prediction together is not
    ///         positive definite
    WeightedResiduals(const Measured& measured, const Prediction& prediction);

    /// Number of entries: measured values of all readings and direct measurements.
    Eigen::Index size() const { return residuals_.size(); }
    /// Whitened residuals r = L^-1 (measured - predicted) [1].
    const Eigen::VectorXd& residuals() const { return residuals_; }
    /// Measured values y of all entries, not whitened, in the units of the readings.
    const Eigen::VectorXd& measured() const { return measured_; }
    /// Squared length of the whitened residuals: chi2 of the fit [1].
    double chi2() const { return residuals_.squaredNorm(); }
    /// ln det(Sigma_measurement + Sigma_simulation) of the covariance matrices in the units of the
    /// readings.
    double log_determinant() const;

    /// Whitens changes of the readings: L^-1 times `columns`, which are in the units of the
    /// readings, with L L' the covariance of measurement and simulation.
    Eigen::MatrixXd whiten(const Eigen::MatrixXd& columns) const;
    /// Changes of the readings in their units from whitened ones: L times `columns`.
    Eigen::MatrixXd unwhiten(const Eigen::MatrixXd& columns) const;
    /// L^-T times whitened columns, with L L' the covariance of measurement and simulation. The
    /// product of the result with a change in the units of the readings equals the product of
    /// `columns` with the whitened change.
    Eigen::MatrixXd whiten_basis(const Eigen::MatrixXd& columns) const;
    /// Lower triangular root R of the whitened covariance of the prediction's errors [1]:
    /// R R' = L^-1 Sigma_simulation L^-T.
    const Eigen::MatrixXd& prediction_root() const { return prediction_root_; }
    /// Trace of P L^-1 C L^-T [1], for a covariance C of the entries in the units of the readings:
    /// expected squared length of whitened errors of this covariance, beyond what a change of the
    /// calibrated parameters can imitate.
    double trace_of_projected(const Eigen::MatrixXd& covariance) const;
    /// Variance [1] of the component of errors along `direction` d, a vector in whitened units, for
    /// errors with the covariance C in the units of the readings: d' L^-1 C L^-T d, with the
    /// Cholesky factor L that whitens.
    double variance_along(const Eigen::VectorXd& direction,
                          const Eigen::MatrixXd& covariance) const;
    /// Removes from whitened changes of the readings what a change of the calibrated parameters can
    /// imitate: P times `columns`.
    Eigen::MatrixXd project(const Eigen::MatrixXd& columns) const;
    /// P times an orthonormal basis of the whitened mean deviations of groups of entries, such as
    /// the entries of each condition; scatter within a group is not in the span of the basis. In a
    /// mean deviation, all entries of a group deviate in proportion to their measured values.
    Eigen::MatrixXd means_over(const std::vector<std::vector<Eigen::Index>>& groups) const;
    /// Change of the calibrated parameters [their units] that comes closest, by least squares, to a
    /// given whitened change of the prediction.
    Eigen::VectorXd share_imitated_by(const Eigen::VectorXd& change) const;
    /// Number of linearly independent combinations of the calibrated parameters that the readings
    /// determine.
    Eigen::Index determined() const { return basis_.cols(); }
    /// Whitened derivatives J = L^-1 df/dtheta of the predictions by the calibrated parameters,
    /// entries x parameters.
    const Eigen::MatrixXd& slopes() const { return slopes_; }

  private:
    Eigen::VectorXd measured_;
    Eigen::MatrixXd lower_;  ///< Cholesky factor L of Sigma_measurement + Sigma_simulation
    Eigen::MatrixXd prediction_root_;
    /// Inverse of Sigma_measurement + Sigma_simulation, computed when it is first needed; the same
    /// for all copies.
    struct Inverse {
        std::once_flag once;
        Eigen::MatrixXd matrix;
    };
    std::shared_ptr<Inverse> inverse_ = std::make_shared<Inverse>();
    Eigen::VectorXd residuals_;
    Eigen::MatrixXd slopes_;
    Eigen::VectorXd lengths_;  ///< norms of the columns of J
    /// Decomposition of J with its columns divided by `lengths_`.
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> decomposed_;
    Eigen::MatrixXd basis_;  ///< orthonormal basis of the columns of J
};

}  // namespace pendular
