#pragma once

#include <Eigen/Core>
#include <vector>

namespace pendular {

/// What one run of dry shear says: stress ratio and solid fraction with their covariance.
struct SurfacePoint {
    double friction = 0;
    double inertial_number = 0;
    Eigen::Vector2d value = Eigen::Vector2d::Zero();
    Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
    double rigidity_shift = 0;  ///< by which rigid beads would pack less densely [1]
};

/// Local polynomial through simulation runs: stress ratio and solid fraction of dry shear as smooth
/// functions of friction and inertial number,
///     y = c0 + c1 x + c2 x^2 + c3 q + c4 x q + c5 q^2,   x = ln[(mu + 0.05)/(mu_c + 0.05)],  q =
///     I^exponent,
/// by generalised least squares over both observables together. Terms that the runs cannot tell
/// (fewer than three frictions, fewer than three inertial numbers) are left out. Where the runs
/// scatter about it more than their standard errors allow, the covariance grows by chi2/dof.
///
/// The logarithm makes both observables nearly straight: from friction 0 to 0.4 their slopes in x
/// change by about a factor 2, that of the stress ratio in friction itself by 9.
class ResponseSurface {
  public:
    /// Uses the points within `window` in x of the centre, all of them where those are too few.
    /// @throws std::invalid_argument for fewer than three points
    ResponseSurface(const std::vector<SurfacePoint>& points, double centre, double exponent,
                    double window);

    /// Row of basis functions at a friction and an inertial number, or its derivative by friction.
    Eigen::RowVectorXd basis(double friction, double inertial_number) const;
    Eigen::RowVectorXd basis_slope(double friction, double inertial_number) const;

    /// (stress ratio, solid fraction) at a friction and an inertial number.
    Eigen::Vector2d value(double friction, double inertial_number) const;

    /// Coefficients of stress ratio, then of solid fraction.
    const Eigen::VectorXd& coefficients() const { return coefficients_; }
    const Eigen::MatrixXd& covariance() const { return covariance_; }
    /// Coefficients of the rigidity shift.
    const Eigen::VectorXd& shift() const { return shift_; }
    Eigen::Index terms() const { return terms_; }

    double chi2() const { return chi2_; }
    int dof() const { return dof_; }
    /// Frictions of the runs it rests on.
    double lowest_friction() const { return lowest_; }
    double highest_friction() const { return highest_; }

    /// x of a friction relative to another.
    static double coordinate(double friction, double centre);
    static double friction_at(double coordinate, double centre);

  private:
    void choose_terms(const std::vector<SurfacePoint>& points);
    void fit(const std::vector<SurfacePoint>& points);

    double centre_, exponent_;
    double lowest_ = 0, highest_ = 0;
    bool quadratic_ = false, inertial_ = false, inertial_quadratic_ = false;
    Eigen::Index terms_ = 0;
    Eigen::VectorXd coefficients_, shift_;
    Eigen::MatrixXd covariance_;
    double chi2_ = 0;
    int dof_ = 0;
};

}  // namespace pendular
