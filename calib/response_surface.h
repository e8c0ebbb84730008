#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <vector>

#include "calib/basis.h"
#include "sim/closures/terms.h"

namespace pendular {

/// What one run of steady shear says: stress ratio and solid fraction with their covariance.
struct SurfacePoint {
    FlowState state;
    Eigen::Vector2d value = Eigen::Vector2d::Zero();
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
    double rigidity_shift = 0;  ///< by which rigid beads would pack less densely [1]
};

/// The dry ones among the points.
std::vector<SurfacePoint> dry_ones(const std::vector<SurfacePoint>& points);

/// Local polynomial through simulation runs: stress ratio and solid fraction as smooth functions of
/// friction, inertial number, reduced pressure and bridge volume,
///     dry:  y = c0 + c1 x + c2 x^2 + c3 q + c4 x q + c5 q^2
///     wet:  y = dry + u (w0 + w1 x + w2 v + w3 u + w4 q + w5 v^2 + w6 u v + w7 u^2)
/// in the coordinates of basis.h, so that capillarity vanishes with 1/P* as it must; by generalised
/// least squares over both observables together. Terms that the runs cannot tell are left out.
/// Where the runs scatter about it more than their standard errors allow, the covariance grows by
/// chi2/dof.
class ResponseSurface {
  public:
    /// Uses the points within `window` in x of the centre, all of them where those are too few.
    /// @throws std::invalid_argument for fewer than three points
    ResponseSurface(const std::vector<SurfacePoint>& points, double centre, double exponent,
                    double window);

    /// Row of basis functions at a state, or its derivative by friction or by ln(bridge volume).
    Eigen::RowVectorXd basis(const FlowState& state) const;
    Eigen::RowVectorXd basis_slope(const FlowState& state) const;
    Eigen::RowVectorXd basis_volume_slope(const FlowState& state) const;

    /// (stress ratio, solid fraction) at a state.
    Eigen::Vector2d value(const FlowState& state) const;

    /// Coefficients of stress ratio, then of solid fraction.
    const Eigen::VectorXd& coefficients() const { return coefficients_; }
    const Eigen::MatrixXd& covariance() const { return covariance_; }
    /// Coefficients of the rigidity shift.
    const Eigen::VectorXd& shift() const { return shift_; }
    Eigen::Index terms() const { return basis_.size(); }

    /// Factor by which the covariance grew for scatter beyond the runs' errors.
    double growth() const { return dof_ > 0 ? std::max(1.0, chi2_ / dof_) : 1.0; }
    /// Covariance of the coefficients of `dry`, made from the dry ones of these points, with those
    /// of this surface. An estimate from part of the data covaries with the better one from all of
    /// it as the better one does with itself; dry terms come first in both.
    Eigen::MatrixXd covariance_with(const ResponseSurface& dry) const;

    double chi2() const { return chi2_; }
    int dof() const { return dof_; }
    /// Frictions of the runs it rests on.
    double lowest_friction() const { return lowest_; }
    double highest_friction() const { return highest_; }

  private:
    void fit(const std::vector<SurfacePoint>& points);
    Coordinates at(const FlowState& state) const { return coordinates(state, centre_, exponent_); }

    double centre_, exponent_;
    double lowest_ = 0, highest_ = 0;
    Basis basis_;
    Eigen::VectorXd coefficients_, shift_;
    Eigen::MatrixXd covariance_;
    double chi2_ = 0;
    int dof_ = 0;
};

}  // namespace pendular
