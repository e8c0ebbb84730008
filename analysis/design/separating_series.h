#pragma once

#include <utility>
#include <vector>

#include "analysis/design/rival.h"

namespace pendular {

/// Series of readings at one or several points that together tell rival models apart.
struct Series {
    /// Part of the series: readings at one point.
    struct Step {
        std::size_t point = 0;  ///< index into the list of points given to the search
        int readings = 0;       ///< number of readings at the point
    };
    /// Readings in the order of the points' waiting times, the longest last; empty where even the
    /// largest number of readings allowed separates no pair of rivals.
    std::vector<Step> steps;
    /// Pairs of rivals, as indices into the list of rivals, that the series separates (tells apart
    /// by a significance test).
    std::vector<std::pair<std::size_t, std::size_t>> separated;
    double cost = 0;  ///< cost of the series [cost of a dry reading]

    /// Total number of readings of the series, at all points.
    int readings() const;
};

/// Cheap series of readings that separates as many pairs of rival models as a greedy search finds.
/// Rivals i and j are separated where D' S^-1 D over all points of the series reaches
/// `telling_noncentrality`, with D the differences of their predictions and
///     S = V/n + J_i C_i J_i' + J_j C_j J_j' + C_f,
/// V/n: covariance of n readings, C: covariance of the parameters, C_f: covariance of the
/// simulation. S contains the errors that points share, so that a second point with the same error
/// adds little. The search adds one reading at a time, where it increases D' S^-1 D of the pairs
/// not yet separated most for its cost; readings that turn out unnecessary are removed at the end.
/// @param relative_noise standard errors of (shear stress, solid fraction) of one reading, over
///        their values [1]
/// @param most_repeats largest number of readings at one point
/// @param most_readings largest number of readings in total
Series separating_series(const std::vector<Rival>& rivals, const std::vector<Point>& points,
                         const Eigen::Vector2d& relative_noise, int most_repeats,
                         int most_readings);

}  // namespace pendular
