#pragma once

#include <Eigen/Core>
#include <Eigen/QR>
#include <vector>

#include "calib/fit/fit.h"

namespace pendular {

/// Residuals of a fit in units of their errors, and what the calibrated parameters leave of
/// changes:
///     r = L^-1 (y - f),   J = L^-1 df/dtheta,   P = I - J (J'J)^-1 J',
/// L L' = Sigma_measurement + Sigma_simulation. P comes from a QR decomposition and is never
/// formed; combinations of parameters that the readings do not determine take nothing away.
class WeightedResiduals {
  public:
    /// @throws std::logic_error where the covariance is not positive definite
    WeightedResiduals(const Measured& measured, const Prediction& prediction);

    Eigen::Index size() const { return residuals_.size(); }
    const Eigen::VectorXd& residuals() const { return residuals_; }
    /// Measured values y.
    const Eigen::VectorXd& measured() const { return measured_; }
    double chi2() const { return residuals_.squaredNorm(); }
    /// ln det(Sigma_measurement + Sigma_simulation), in the units of the readings.
    double log_determinant() const;

    /// Whitened changes: L^-1 times columns in the units of the readings.
    Eigen::MatrixXd whiten(const Eigen::MatrixXd& columns) const;
    /// L^-T times whitened columns: what their products with whitened changes are with the changes.
    Eigen::MatrixXd whiten_basis(const Eigen::MatrixXd& columns) const;
    /// Symmetric root of the prediction's covariance in whitened units.
    const Eigen::MatrixXd& prediction_root() const { return prediction_root_; }
    /// L^-1 C L^-T of a matrix in those units.
    Eigen::MatrixXd whiten_covariance(const Eigen::MatrixXd& covariance) const;
    /// P times whitened columns.
    Eigen::MatrixXd project(const Eigen::MatrixXd& columns) const;
    /// Orthonormal columns that span the means over groups of entries, the calibrated parameters
    /// projected out: what scatters within the groups is in none of them. Entries of a group are
    /// alike in proportion to what was measured.
    Eigen::MatrixXd means_over(const std::vector<std::vector<Eigen::Index>>& groups) const;
    /// Change of the calibrated parameters that imitates a whitened change of the prediction.
    Eigen::VectorXd share_imitated_by(const Eigen::VectorXd& change) const;
    /// Number of calibrated parameters that the readings determine.
    Eigen::Index determined() const { return basis_.cols(); }
    /// Whitened derivatives J.
    const Eigen::MatrixXd& slopes() const { return slopes_; }

  private:
    Eigen::VectorXd measured_;
    Eigen::MatrixXd lower_;  ///< L
    Eigen::MatrixXd prediction_root_;
    Eigen::VectorXd residuals_;
    Eigen::MatrixXd slopes_;
    Eigen::VectorXd lengths_;  ///< of the columns of J, by which they are divided first
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> decomposed_;
    Eigen::MatrixXd basis_;  ///< orthonormal, of the columns of J
};

}  // namespace pendular
