#include "calib/model/discrepancy.h"

#include <cmath>
#include <numbers>

namespace pendular {
namespace {

/// Share [1] of the variance that varies smoothly with the condition; the rest differs from one
/// condition to the next. Chosen: both kinds were seen between codes and between a code and its
/// emulator, and neither alone covers the other.
constexpr double smooth_share = 0.5;
/// Ratio [1] of the correlation lengths of the smooth part to those of the rest. At a tenth of the
/// lengths, replicates whose conditions differ by a few per cent share their error, and conditions
/// that an experimenter would call different do not.
constexpr double length_ratio = 10;

/// Correlation lengths of the smooth part along ln(normal stress), sqrt(inertial number) and
/// sqrt(liquid content) [1]. Chosen: a decade of stress, and from 0 to 0.01 for the other two,
/// since a wrong law errs alike at neighbouring conditions.
constexpr double stress_length = std::numbers::ln10;
constexpr double rate_length = 0.1;
constexpr double liquid_length = 0.1;

double square(double x) {
    return x * x;
}

}  // namespace

double discrepancy_correlation(const Condition& a, const Condition& b) {
    const double distance =
        square(std::log(a.normal_stress / b.normal_stress) / stress_length) +
        square((std::sqrt(a.inertial_number) - std::sqrt(b.inertial_number)) / rate_length) +
        square((std::sqrt(a.liquid_content) - std::sqrt(b.liquid_content)) / liquid_length);
    return smooth_share * std::exp(-distance / 2) +
           (1 - smooth_share) * std::exp(-square(length_ratio) * distance / 2);
}

Eigen::MatrixXd discrepancy_covariance(const std::vector<Condition>& conditions,
                                       const Eigen::VectorXd& values,
                                       const std::array<double, 2>& discrepancy) {
    Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(values.size(), values.size());
    for (std::size_t a = 0; a < conditions.size(); ++a) {
        for (std::size_t b = 0; b < conditions.size(); ++b) {
            const double correlation = discrepancy_correlation(conditions[a], conditions[b]);
            for (const std::size_t o : {0, 1}) {
                const auto i = static_cast<Eigen::Index>(2 * a + o),
                           k = static_cast<Eigen::Index>(2 * b + o);
                covariance(i, k) = square(discrepancy[o]) * correlation * values(i) * values(k);
            }
        }
    }
    return covariance;
}

}  // namespace pendular
