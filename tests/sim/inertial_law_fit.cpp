#include "tests/sim/inertial_law_fit.h"

#include <Eigen/Dense>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <set>
#include <stdexcept>

namespace pendular::closures {
namespace {

/// Exponents among which the best is sought [1].
constexpr double least_exponent = 0.1, largest_exponent = 3;

/// Points over their standard errors, as a linear problem where the exponent is given.
class Problem {
  public:
    explicit Problem(const std::vector<InertialPoint>& points)
        : log_number_(std::ssize(points)), weight_(std::ssize(points)), value_(std::ssize(points)) {
        Eigen::Index k = 0;
        for (const InertialPoint& point : points) {
            log_number_(k) = std::log(point.inertial_number);
            weight_(k) = 1 / point.standard_error;
            value_(k++) = point.value / point.standard_error;
        }
    }
    /// Limit and amplitude that minimise chi2 at an exponent.
    Eigen::Vector2d best(double exponent) const {
        return columns(exponent).colPivHouseholderQr().solve(value_);
    }
    double chi2(double exponent) const {
        return (value_ - columns(exponent) * best(exponent)).squaredNorm();
    }
    /// Covariance of limit, amplitude and exponent.
    Eigen::Matrix3d covariance(double exponent) const {
        Eigen::MatrixX3d slopes(value_.size(), 3);
        slopes.leftCols<2>() = columns(exponent);
        slopes.col(2) = best(exponent)(1) * log_number_.cwiseProduct(slopes.col(1));
        return (slopes.transpose() * slopes).inverse();
    }

  private:
    Eigen::MatrixX2d columns(double exponent) const {
        Eigen::MatrixX2d columns(value_.size(), 2);
        columns.col(0) = weight_;
        columns.col(1) = weight_.array() * (exponent * log_number_.array()).exp();
        return columns;
    }
    Eigen::VectorXd log_number_, weight_, value_;
};

}  // namespace

InertialLaw fit_inertial_law(const std::vector<InertialPoint>& points) {
    std::set<double> numbers;
    for (const InertialPoint& point : points) {
        numbers.insert(point.inertial_number);
    }
    if (points.size() < 4 || numbers.size() < 3) {
        throw std::invalid_argument(
            "a law of the inertial number needs 4 points at 3 inertial numbers");
    }
    const Problem problem(points);
    constexpr int bits = 30;
    const auto [exponent, chi2] = boost::math::tools::brent_find_minima(
        [&](double n) { return problem.chi2(n); }, least_exponent, largest_exponent, bits);
    const Eigen::Vector2d best = problem.best(exponent);
    const Eigen::Vector3d errors = problem.covariance(exponent).diagonal().cwiseSqrt();
    return {.limit = {best(0), errors(0)},
            .amplitude = {best(1), errors(1)},
            .exponent = {exponent, errors(2)},
            .chi2 = chi2,
            .dof = static_cast<int>(points.size()) - 3};
}

}  // namespace pendular::closures
