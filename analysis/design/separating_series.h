#pragma once

#include <utility>
#include <vector>

#include "analysis/design/rival.h"

namespace pendular {

/// Series of readings at one or several points that together tell rival models apart.
struct Series {
    /// Part of the series: readings at one point.
    struct Step {
        /// Point of the readings, as index into the list of points given to the search.
        std::size_t point = 0;
        /// Number of readings to make at the point.
        int readings = 0;
    };
    /// Readings at each point, in increasing order of the waiting times of the points; empty if
    /// even the largest number of readings allowed tells no pair of rival models apart.
    std::vector<Step> steps;
    /// Pairs of rival models, as indices into the list of rivals, that the series tells apart: with
    /// a probability of 0.8, a test at 5 % significance distinguishes both models.
    std::vector<std::pair<std::size_t, std::size_t>> separated;
    /// Cost of all readings of the series, with fillings and waiting [cost of a dry reading].
    double cost = 0;

    /// Total number of readings of the series, at all points.
    int readings() const;
};

/// Returns a cheap series of readings that separates (tells apart) as many pairs of rival models as
/// a greedy search finds. Rivals i and j are separated if D' S^-1 D for all points of the series
/// together reaches `telling_noncentrality`, with the difference D of their predictions and
///     S = V/n + J_i C_i J_i' + J_j C_j J_j' + C_f,
/// V/n: covariance of n readings; J: derivatives of the predictions with respect to the parameters;
/// C: covariance of the parameters; C_f: covariance of the simulation's errors. S contains the
/// errors that points share, so that a second point with the same error adds little. The search
/// adds one reading at a time, at the point where the reading increases D' S^-1 D of the pairs not
/// yet separated most for its cost. Finally it removes readings that turned out to be unnecessary.
/// @param relative_noise relative standard errors of the shear stress and the solid fraction of one
///        reading, in this order [1]
/// @param most_repeats largest number of readings at one point
/// @param most_readings largest number of readings in total
Series separating_series(const std::vector<Rival>& rivals, const std::vector<Point>& points,
                         const Eigen::Vector2d& relative_noise, int most_repeats,
                         int most_readings);

}  // namespace pendular
