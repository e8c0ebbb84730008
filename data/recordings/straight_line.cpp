#include "data/recordings/straight_line.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pendular {
namespace {

/// Relative error that sums of some hundred numbers of 16 digits leave.
constexpr double rounding_of_sums = 1e-12;

}  // namespace

std::optional<StraightLine> straight_line(const std::vector<double>& x,
                                          const std::vector<double>& y) {
    constexpr std::size_t fewest_for_scatter = 4;
    const double n = static_cast<double>(x.size());
    const double mean_x = std::accumulate(x.begin(), x.end(), 0.0) / n;
    const double mean_y = std::accumulate(y.begin(), y.end(), 0.0) / n;
    double all_squares = 0, squares = 0, products = 0, largest = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        all_squares += x[i] * x[i];
        squares += (x[i] - mean_x) * (x[i] - mean_x);
        products += (x[i] - mean_x) * (y[i] - mean_y);
        largest = std::max(largest, std::abs(y[i]));
    }
    if (!(squares > rounding_of_sums * all_squares)) return std::nullopt;
    StraightLine line{.slope = products / squares};
    line.intercept = mean_y - line.slope * mean_x;
    if (std::abs(line.intercept) <= rounding_of_sums * largest) line.intercept = 0;
    if (x.size() < fewest_for_scatter) return line;
    double residuals = 0;
    for (std::size_t i = 0; i < x.size(); ++i)
        residuals += std::pow(y[i] - mean_y - line.slope * (x[i] - mean_x), 2);
    if (residuals <= n * std::pow(rounding_of_sums * largest, 2)) residuals = 0;
    const double variance = residuals / (n - 2);
    line.covariance = LineCovariance{.intercept = variance * (1 / n + mean_x * mean_x / squares),
                                     .slope = variance / squares,
                                     .both = -variance * mean_x / squares};
    return line;
}

}  // namespace pendular
