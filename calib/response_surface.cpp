#include "calib/response_surface.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace pendular {
namespace {

constexpr double friction_scale = 0.05;

/// Number of values that differ by more than one per mille.
std::size_t distinct(std::vector<double> values) {
    std::ranges::sort(values);
    const auto same = [](double a, double b) { return std::abs(a - b) <= 1e-3 * std::abs(b); };
    return static_cast<std::size_t>(std::unique(values.begin(), values.end(), same) -
                                    values.begin());
}

std::vector<SurfacePoint> within(const std::vector<SurfacePoint>& points, double centre,
                                 double window) {
    std::vector<SurfacePoint> near;
    std::ranges::copy_if(points, std::back_inserter(near), [&](const SurfacePoint& p) {
        return std::abs(ResponseSurface::coordinate(p.friction, centre)) <= window;
    });
    return near;
}

std::size_t frictions(const std::vector<SurfacePoint>& points) {
    std::vector<double> values;
    for (const auto& p : points) {
        values.push_back(p.friction + friction_scale);
    }
    return distinct(values);
}

/// Mean correlation between the two observables over the runs: a single run knows its own poorly.
double pooled_correlation(const std::vector<SurfacePoint>& points) {
    double sum = 0;
    for (const auto& p : points) {
        sum += p.covariance(0, 1) / std::sqrt(p.covariance(0, 0) * p.covariance(1, 1));
    }
    return sum / static_cast<double>(points.size());
}

}  // namespace

double ResponseSurface::coordinate(double friction, double centre) {
    return std::log((friction + friction_scale) / (centre + friction_scale));
}

double ResponseSurface::friction_at(double coordinate, double centre) {
    return (centre + friction_scale) * std::exp(coordinate) - friction_scale;
}

ResponseSurface::ResponseSurface(const std::vector<SurfacePoint>& points, double centre,
                                 double exponent, double window)
    : centre_(centre), exponent_(exponent) {
    if (points.size() < 3) {
        throw std::invalid_argument("a response surface needs at least three runs");
    }
    const auto near = within(points, centre, window);
    const auto& used = near.size() >= 3 && frictions(near) >= 3 ? near : points;
    choose_terms(used);
    fit(used);
}

void ResponseSurface::choose_terms(const std::vector<SurfacePoint>& points) {
    std::vector<double> inertial_numbers;
    for (const auto& p : points) {
        inertial_numbers.push_back(p.inertial_number);
    }
    const auto by_friction = std::ranges::minmax(points, {}, &SurfacePoint::friction);
    lowest_ = by_friction.min.friction;
    highest_ = by_friction.max.friction;
    quadratic_ = frictions(points) >= 3;
    inertial_ = distinct(inertial_numbers) >= 2;
    inertial_quadratic_ = distinct(inertial_numbers) >= 3;
    terms_ = 2 + quadratic_ + 2 * inertial_ + inertial_quadratic_;
}

Eigen::RowVectorXd ResponseSurface::basis(double friction, double inertial_number) const {
    const double x = coordinate(friction, centre_), q = std::pow(inertial_number, exponent_);
    Eigen::RowVectorXd row(terms_);
    Eigen::Index k = 0;
    row(k++) = 1;
    row(k++) = x;
    if (quadratic_) {
        row(k++) = x * x;
    }
    if (inertial_) {
        row(k++) = q;
        row(k++) = x * q;
    }
    if (inertial_quadratic_) {
        row(k++) = q * q;
    }
    return row;
}

Eigen::RowVectorXd ResponseSurface::basis_slope(double friction, double inertial_number) const {
    const double x = coordinate(friction, centre_), q = std::pow(inertial_number, exponent_);
    Eigen::RowVectorXd row(terms_);
    Eigen::Index k = 0;
    row(k++) = 0;
    row(k++) = 1;
    if (quadratic_) {
        row(k++) = 2 * x;
    }
    if (inertial_) {
        row(k++) = 0;
        row(k++) = q;
    }
    if (inertial_quadratic_) {
        row(k++) = 0;
    }
    return row / (friction + friction_scale);
}

Eigen::Vector2d ResponseSurface::value(double friction, double inertial_number) const {
    const Eigen::RowVectorXd row = basis(friction, inertial_number);
    return {row.dot(coefficients_.head(terms_)), row.dot(coefficients_.tail(terms_))};
}

void ResponseSurface::fit(const std::vector<SurfacePoint>& points) {
    const auto rows = static_cast<Eigen::Index>(points.size());
    const double correlation = pooled_correlation(points);
    Eigen::MatrixXd design = Eigen::MatrixXd::Zero(2 * rows, 2 * terms_);
    Eigen::VectorXd target(2 * rows);
    Eigen::MatrixXd shift_design(rows, terms_);
    Eigen::VectorXd shift_target(rows);
    for (Eigen::Index k = 0; k < rows; ++k) {
        const auto& p = points[static_cast<std::size_t>(k)];
        const Eigen::RowVectorXd row = basis(p.friction, p.inertial_number);
        Eigen::Matrix2d covariance = p.covariance;
        covariance(0, 1) = covariance(1, 0) =
            correlation * std::sqrt(covariance(0, 0) * covariance(1, 1));
        // Whitened by the run's own covariance: W W^T = C^-1 through the inverse Cholesky factor.
        const Eigen::Matrix2d whiten =
            covariance.llt().matrixL().solve(Eigen::Matrix2d::Identity());
        design.block(2 * k, 0, 2, terms_) = whiten.col(0) * row;
        design.block(2 * k, terms_, 2, terms_) = whiten.col(1) * row;
        target.segment<2>(2 * k) = whiten * p.value;
        shift_design.row(k) = row;
        shift_target(k) = p.rigidity_shift;
    }
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(design);
    coefficients_ = qr.solve(target);
    chi2_ = (target - design * coefficients_).squaredNorm();
    dof_ = static_cast<int>(2 * rows - qr.rank());
    const double growth = dof_ > 0 ? std::max(1.0, chi2_ / dof_) : 1.0;
    covariance_ =
        growth * (design.transpose() * design).completeOrthogonalDecomposition().pseudoInverse();
    shift_ = shift_design.colPivHouseholderQr().solve(shift_target);
}

}  // namespace pendular
