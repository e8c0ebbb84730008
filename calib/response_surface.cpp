#include "calib/response_surface.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

namespace pendular {
namespace {

constexpr double same_setting = 1e-3;
/// The liquid content follows from the bridge volume only by simulation, so settings of volumes
/// scatter; so do reduced pressures that readings set.
constexpr double same_volume = 0.1, same_pressure = 0.03;
/// From these on curvature in 1/P* to the third order, and in ln V0, is worth a term.
constexpr double strong_cohesion = 0.6, wide_volumes = 2.0;
constexpr double friction_offset = 0.05;  // so that frictions near 0 are told apart

std::vector<SurfacePoint> within(const std::vector<SurfacePoint>& points, double centre,
                                 double window) {
    std::vector<SurfacePoint> near;
    std::ranges::copy_if(points, std::back_inserter(near), [&](const SurfacePoint& p) {
        return std::abs(friction_coordinate(p.state.friction, centre)) <= window;
    });
    return near;
}

template <typename Value>
std::vector<double> settings(const std::vector<SurfacePoint>& points, bool wet_only,
                             const Value& value) {
    std::vector<double> result;
    for (const auto& p : points) {
        if (!wet_only || !p.state.dry()) {
            result.push_back(value(p.state));
        }
    }
    return result;
}

double shifted_friction(const FlowState& s) {
    return s.friction + friction_offset;
}
double inertia(const FlowState& s) {
    return s.inertial_number;
}

/// The dry terms that the dry points can tell, whatever wet ones there are besides.
void add_dry_terms(Basis& basis, const std::vector<SurfacePoint>& all) {
    const auto points = dry_ones(all);
    const std::size_t inertial_numbers = distinct(settings(points, false, inertia), same_setting);
    basis.add({});
    basis.add({.x = 1});
    if (distinct(settings(points, false, shifted_friction), same_setting) >= 3) {
        basis.add({.x = 2});
    }
    if (inertial_numbers >= 2) {
        basis.add({.q = 1});
        basis.add({.x = 1, .q = 1});
    }
    if (inertial_numbers >= 3) {
        basis.add({.q = 2});
    }
}

/// The wet terms that the points can tell.
void add_wet_terms(Basis& basis, const std::vector<SurfacePoint>& points) {
    const auto cohesion =
        settings(points, true, [](const FlowState& s) { return s.inverse_pressure; });
    if (cohesion.empty()) {
        return;
    }
    const auto volumes = settings(points, true, [](const FlowState& s) { return s.bridge_volume; });
    const auto [dryest, wettest] = std::ranges::minmax(volumes);
    const std::size_t pressures = distinct(cohesion, same_pressure);
    basis.add({.u = 1});
    if (distinct(settings(points, true, shifted_friction), same_setting) >= 2) {
        basis.add({.x = 1, .u = 1});
    }
    if (distinct(volumes, same_volume) >= 2) {
        basis.add({.u = 1, .v = 1});
    }
    if (pressures >= 2) {
        basis.add({.u = 2});
    }
    if (distinct(settings(points, true, inertia), same_setting) >= 2) {
        basis.add({.q = 1, .u = 1});
    }
    if (wettest / dryest > std::exp(wide_volumes) && distinct(volumes, same_volume) >= 3) {
        basis.add({.u = 1, .v = 2});
    }
    if (pressures >= 4 && std::ranges::max(cohesion) > strong_cohesion) {
        basis.add({.u = 2, .v = 1});
        basis.add({.u = 3});
    }
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

std::vector<SurfacePoint> dry_ones(const std::vector<SurfacePoint>& points) {
    std::vector<SurfacePoint> dry;
    std::ranges::copy_if(points, std::back_inserter(dry),
                         [](const SurfacePoint& p) { return p.state.dry(); });
    return dry;
}

ResponseSurface::ResponseSurface(const std::vector<SurfacePoint>& points, double centre,
                                 double exponent, double window)
    : centre_(centre), exponent_(exponent) {
    if (points.size() < 3) {
        throw std::invalid_argument("a response surface needs at least three runs");
    }
    const auto near = within(points, centre, window);
    const bool enough =
        near.size() >= 3 && distinct(settings(near, false, shifted_friction), same_setting) >= 3;
    const auto& used = enough ? near : points;
    add_dry_terms(basis_, used);
    add_wet_terms(basis_, used);
    const auto frictions = settings(used, false, [](const FlowState& s) { return s.friction; });
    lowest_ = std::ranges::min(frictions);
    highest_ = std::ranges::max(frictions);
    fit(used);
}

Eigen::RowVectorXd ResponseSurface::basis(const FlowState& state) const {
    return basis_.values(at(state));
}

Eigen::RowVectorXd ResponseSurface::basis_slope(const FlowState& state) const {
    return basis_.slopes_in_x(at(state)) * friction_slope(state.friction);
}

Eigen::RowVectorXd ResponseSurface::basis_volume_slope(const FlowState& state) const {
    return basis_.slopes_in_v(at(state));
}

Eigen::Vector2d ResponseSurface::value(const FlowState& state) const {
    const Eigen::RowVectorXd row = basis(state);
    return {row.dot(coefficients_.head(terms())), row.dot(coefficients_.tail(terms()))};
}

Eigen::MatrixXd ResponseSurface::covariance_with(const ResponseSurface& dry) const {
    Eigen::MatrixXd shared(2 * dry.terms(), 2 * terms());
    shared << covariance_.topRows(dry.terms()), covariance_.middleRows(terms(), dry.terms());
    return std::sqrt(dry.growth() / growth()) * shared;
}

void ResponseSurface::fit(const std::vector<SurfacePoint>& points) {
    const auto rows = static_cast<Eigen::Index>(points.size());
    const double correlation = pooled_correlation(points);
    Eigen::MatrixXd design = Eigen::MatrixXd::Zero(2 * rows, 2 * terms());
    Eigen::VectorXd target(2 * rows);
    Eigen::MatrixXd shift_design(rows, terms());
    Eigen::VectorXd shift_target(rows);
    for (Eigen::Index k = 0; k < rows; ++k) {
        const auto& p = points[static_cast<std::size_t>(k)];
        const Eigen::RowVectorXd row = basis(p.state);
        Eigen::Matrix2d covariance = p.covariance;
        covariance(0, 1) = covariance(1, 0) =
            correlation * std::sqrt(covariance(0, 0) * covariance(1, 1));
        // Whitened by the run's own covariance: W W^T = C^-1 through the inverse Cholesky factor.
        const Eigen::Matrix2d whiten =
            covariance.llt().matrixL().solve(Eigen::Matrix2d::Identity());
        design.block(2 * k, 0, 2, terms()) = whiten.col(0) * row;
        design.block(2 * k, terms(), 2, terms()) = whiten.col(1) * row;
        target.segment<2>(2 * k) = whiten * p.value;
        shift_design.row(k) = row;
        shift_target(k) = p.rigidity_shift;
    }
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(design);
    coefficients_ = qr.solve(target);
    chi2_ = (target - design * coefficients_).squaredNorm();
    dof_ = static_cast<int>(2 * rows - qr.rank());
    covariance_ =
        growth() * (design.transpose() * design).completeOrthogonalDecomposition().pseudoInverse();
    shift_ = shift_design.colPivHouseholderQr().solve(shift_target);
}

}  // namespace pendular
