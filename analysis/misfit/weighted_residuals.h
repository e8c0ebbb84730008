#pragma once

#include <Eigen/Core>
#include <Eigen/QR>
#include <memory>
#include <mutex>
#include <vector>

#include "calib/fit/fit.h"

namespace pendular {

/// Residuals r of a fit in units of their errors (whitened), with the projection P that removes
/// from a change of the readings the part that a change of the calibrated parameters theta can
/// imitate:
///     r = L^-1 (y - f),   J = L^-1 df/dtheta,   P = I - J (J'J)^-1 J',
/// with the measured values y, the predictions f and the Cholesky factor L of the covariance
/// L L' = Sigma = Sigma_measurement + Sigma_simulation. P ignores combinations of parameters that
/// the readings do not determine. Rows are for measured values: two for each reading in turn, then
/// one for each direct measurement. Whitened numbers have no unit; others have those of the
/// measured values.
class WeightedResiduals {
  public:
    /// Whitens the difference between measured values and prediction.
    /// @param prediction at the fitted parameters, with derivatives
    /// @throws std::logic_error if Sigma is not positive definite
    WeightedResiduals(const Measured& measured, const Prediction& prediction);

    /// Returns the number of measured values.
    Eigen::Index size() const { return residuals_.size(); }
    /// Returns the whitened residuals r [1].
    const Eigen::VectorXd& residuals() const { return residuals_; }
    /// Returns the measured values y, not whitened.
    const Eigen::VectorXd& measured() const { return measured_; }
    /// Returns chi2, |r|^2 [1].
    double chi2() const { return residuals_.squaredNorm(); }
    /// Returns ln det Sigma.
    double log_determinant() const;

    /// Returns L^-1 `columns` [1], the whitened changes.
    Eigen::MatrixXd whiten(const Eigen::MatrixXd& columns) const;
    /// Returns L^-T `columns`, whose scalar products with changes of the readings equal those of
    /// `columns` with the whitened changes.
    Eigen::MatrixXd whiten_basis(const Eigen::MatrixXd& columns) const;
    /// Returns the lower triangular root R of the whitened covariance of the predictions [1]:
    /// R R' = L^-1 Sigma_simulation L^-T.
    const Eigen::MatrixXd& prediction_root() const { return prediction_root_; }
    /// Returns tr(P L^-1 C L^-T) [1]: expected squared norm of the part of errors of the covariance
    /// C that no change of the calibrated parameters can imitate.
    double trace_of_projected(const Eigen::MatrixXd& covariance) const;
    /// Returns d' L^-1 C L^-T d [1]: variance of errors of the covariance C along a whitened
    /// direction d.
    double variance_along(const Eigen::VectorXd& direction,
                          const Eigen::MatrixXd& covariance) const;
    /// Returns P `columns` [1], for whitened changes.
    Eigen::MatrixXd project(const Eigen::MatrixXd& columns) const;
    /// Returns P B [1], with an orthonormal basis B of the whitened mean deviations of groups of
    /// measured values, such as those at one condition. In a mean deviation, all values of a group
    /// deviate in proportion to their measured size.
    /// @param groups indices of the measured values of each group
    Eigen::MatrixXd means_over(const std::vector<std::vector<Eigen::Index>>& groups) const;
    /// Returns the change of the calibrated parameters [their units] that imitates a whitened
    /// change of the predictions best, by least squares.
    Eigen::VectorXd parameter_shift_of(const Eigen::VectorXd& change) const;
    /// Returns the rank of J: number of combinations of the parameters that the readings determine.
    Eigen::Index determined() const { return basis_.cols(); }
    /// Returns the whitened derivatives J [1/unit of each parameter].
    const Eigen::MatrixXd& slopes() const { return slopes_; }

  private:
    Eigen::VectorXd measured_;
    Eigen::MatrixXd lower_;  ///< L
    Eigen::MatrixXd prediction_root_;
    /// Inverse of Sigma, computed when it is first needed and shared by all copies of the object.
    /// The flag makes the first use by several threads safe.
    struct Inverse {
        std::once_flag once;
        Eigen::MatrixXd matrix;
    };
    std::shared_ptr<Inverse> inverse_ = std::make_shared<Inverse>();
    Eigen::VectorXd residuals_;
    Eigen::MatrixXd slopes_;
    Eigen::VectorXd lengths_;  ///< norms of the columns of J
    /// QR decomposition of J with columns divided by `lengths_`, so that the rank does not depend
    /// on the units of the parameters.
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> decomposed_;
    Eigen::MatrixXd basis_;  ///< orthonormal basis of the columns of J
};

}  // namespace pendular
