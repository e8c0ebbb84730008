#include "calib/fit/undetermined.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Dense>

namespace pendular {

std::vector<std::string> undetermined(const Fit& fit, const std::vector<Parameter>& parameters) {
    /// Smallest component of a parameter, relative to the largest, that counts as part of a
    /// combination [1].
    constexpr double smallest_of_interest = 0.01;
    const auto n = static_cast<Eigen::Index>(parameters.size());
    Eigen::VectorXd ranges(n);
    for (Eigen::Index k = 0; k < n; ++k) {
        const Parameter& p = parameters[static_cast<std::size_t>(k)];
        ranges(k) = p.upper - p.lower;
    }
    std::vector<std::string> sentences;
    if (n == 0 || !fit.covariance.allFinite() || !(ranges.minCoeff() > 0)) {
        return sentences;
    }
    const Eigen::MatrixXd scaled =
        ranges.cwiseInverse().asDiagonal() * fit.covariance * ranges.cwiseInverse().asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> axes(scaled);
    for (Eigen::Index axis = n - 1; axis >= 0 && axes.eigenvalues()(axis) > 1; --axis) {
        const Eigen::VectorXd direction = axes.eigenvectors().col(axis);
        const double largest = direction.cwiseAbs().maxCoeff();
        std::vector<std::string> names, steps;
        double first = 0;
        for (Eigen::Index k = 0; k < n; ++k) {
            if (std::abs(direction(k)) < smallest_of_interest * largest) {
                continue;
            }
            const Parameter& p = parameters[static_cast<std::size_t>(k)];
            const double step = direction(k) * ranges(k);
            first = first == 0 ? step : first;
            names.push_back(p.name);
            steps.push_back(
                fmt::format("{:.3g}{}", step / first, p.unit == "1" ? "" : " " + p.unit));
        }
        sentences.push_back(
            names.size() == 1
                ? fmt::format("The readings do not determine {}: drop it, or measure where it "
                              "changes the readings.",
                              names.front())
                : fmt::format(
                      "The readings do not tell {} apart: changed together in the proportion {} "
                      "they fit equally well. Drop one, or measure where they differ.",
                      fmt::join(names, " and "), fmt::join(steps, " : ")));
    }
    return sentences;
}

}  // namespace pendular
