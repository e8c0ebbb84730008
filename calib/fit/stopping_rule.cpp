#include "calib/fit/stopping_rule.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pendular {

double Enlargement::excess(double largest) const {
    const auto added_variance = [](double enlarged) { return (1 + enlarged) * (1 + enlarged) - 1; };
    return added_variance(size) / added_variance(largest);
}

std::string text_of(const Enlargement& enlargement) {
    return fmt::format(
        "the error of {} by {:.0f} %",
        enlargement.parameter.empty() ? "a predicted reading" : enlargement.parameter,
        100 * enlargement.size);
}

double enlargement(double noise, double rest) {
    constexpr double most = 100;  // in place of infinity, where the runs cause the whole error
    if (!(noise > 0)) {
        return 0;
    }
    return rest > 0 ? std::min(most, std::sqrt(1 + noise / rest) - 1) : most;
}

Enlargement enlargement_by_runs(const Fit& fit, const Measured& measured,
                                const std::vector<Parameter>& parameters) {
    Enlargement largest;
    for (Eigen::Index k = 0; k < fit.parameters.size(); ++k) {
        const double noise = fit.run_part(k, k);
        const double size = enlargement(noise, std::pow(fit.standard_error(k), 2) - noise);
        if (size > largest.size) {
            largest = {size, parameters[static_cast<std::size_t>(k)].name};
        }
    }
    for (Eigen::Index k = 0; k < measured.value.size(); ++k) {
        const double noise = fit.prediction.run_noise(k, k);
        const double size =
            enlargement(noise, measured.covariance(k, k) + fit.prediction.covariance(k, k) - noise);
        if (size > largest.size) {
            largest = {size};
        }
    }
    return largest;
}

}  // namespace pendular
