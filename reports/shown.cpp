#include "reports/shown.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pendular {

std::vector<std::string> broken_name(const std::string& name) {
    constexpr std::size_t longest = 10;
    std::vector<std::string> lines = {""};
    for (std::size_t begin = 0; begin < name.size();) {
        const std::size_t end = std::min(name.find('-', begin), name.size() - 1) + 1;
        const std::string piece = name.substr(begin, end - begin);
        if (begin > 0 && lines.back().size() + piece.size() > longest) {
            lines.emplace_back();
        }
        lines.back() += piece;
        begin = end;
    }
    return lines;
}

bool spans_decade(const std::vector<double>& values) {
    const auto [least, greatest] = std::ranges::minmax(values);
    return least > 0 && greatest > 10 * least;
}

Shown shown(const Reading& r) {
    const double s = r.condition.normal_stress;
    return {{r.value(0) / s, r.value(1)},
            {std::sqrt(r.covariance(0, 0)) / s, std::sqrt(r.covariance(1, 1))}};
}

Shown mean_of(const std::vector<Reading>& readings) {
    Shown mean{};
    for (std::size_t o = 0; o < 2; ++o) {
        double weights = 0;
        for (const auto& reading : readings) {
            const Shown one = shown(reading);
            const double weight = 1 / (one.error[o] * one.error[o]);
            mean.value[o] += weight * one.value[o];
            weights += weight;
        }
        mean.value[o] /= weights;
        mean.error[o] = 1 / std::sqrt(weights);
    }
    return mean;
}

std::string inertial_text(double inertial_number) {
    return inertial_number == 0 ? "I → 0" : fmt::format("I = {:.3g}", inertial_number);
}

}  // namespace pendular
