#pragma once

#include <optional>
#include <vector>

namespace pendular {

/// Variances and covariance of a line's intercept and slope, in the squared units of these.
struct LineCovariance {
    double intercept = 0, slope = 0, both = 0;
};

/// Straight line y = intercept + slope x.
struct StraightLine {
    double intercept = 0;  ///< in the unit of y
    double slope = 0;
    /// From the scatter of the points about the line over n - 2, the degrees of freedom. Empty for
    /// fewer than four points: with one degree of freedom, the scatter is not known.
    std::optional<LineCovariance> covariance = {};
};

/// Returns the straight line through points by ordinary least squares; empty without two different
/// x. An intercept and a scatter as small as errors of rounding are 0.
std::optional<StraightLine> straight_line(const std::vector<double>& x,
                                          const std::vector<double>& y);

}  // namespace pendular
