#include "calib/fit/discrepancy.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace pendular {
namespace {

constexpr double stress_length = 2.302585092994046;  // ln 10
constexpr double rate_length = 0.1;
constexpr double liquid_length = 0.1;

/// Share of the variance of a discrepancy that its neglected sources have [1].
constexpr double negligible = 1e-6;

double square(double x) {
    return x * x;
}

/// Number that no source of a shared error of these readings has, nor any larger one.
std::size_t next_source(const std::vector<Reading>& readings) {
    std::size_t next = 0;
    for (const Reading& reading : readings) {
        for (const SharedError& error : reading.shared) {
            next = std::max(next, error.source + 1);
        }
    }
    return next;
}

}  // namespace

double discrepancy_correlation(const Condition& a, const Condition& b) {
    const double distance =
        square(std::log(a.normal_stress / b.normal_stress) / stress_length) +
        square((std::sqrt(a.inertial_number) - std::sqrt(b.inertial_number)) / rate_length) +
        square((std::sqrt(a.liquid_content) - std::sqrt(b.liquid_content)) / liquid_length);
    return std::exp(-distance / 2);
}

void add_discrepancy(std::vector<Reading>& readings, const std::array<double, 2>& discrepancy) {
    if (readings.empty() || (discrepancy[0] == 0 && discrepancy[1] == 0)) return;
    const auto n = static_cast<Eigen::Index>(readings.size());
    const auto condition = [&](Eigen::Index k) -> const Condition& {
        return readings[static_cast<std::size_t>(k)].condition;
    };
    const Eigen::MatrixXd correlation =
        Eigen::MatrixXd::NullaryExpr(n, n, [&](Eigen::Index i, Eigen::Index j) {
            return discrepancy_correlation(condition(i), condition(j));
        });
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(correlation);
    std::size_t source = next_source(readings);
    for (Eigen::Index mode = n - 1; mode >= 0; --mode) {
        const double variance = modes.eigenvalues()(mode);
        if (variance < negligible * static_cast<double>(n)) break;
        for (const Eigen::Index o : {0, 1}) {
            const double relative = discrepancy[static_cast<std::size_t>(o)] * std::sqrt(variance);
            if (relative == 0) continue;
            for (Eigen::Index k = 0; k < n; ++k) {
                Reading& reading = readings[static_cast<std::size_t>(k)];
                SharedError error{.source = source, .known = true};
                error.size(o) = relative * modes.eigenvectors()(k, mode) * reading.value(o);
                error.estimated = error.size;
                reading.covariance(o, o) += square(error.size(o));
                reading.shared.push_back(error);
            }
            ++source;
        }
    }
}

}  // namespace pendular
