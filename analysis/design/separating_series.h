#pragma once

#include <utility>
#include <vector>

#include "analysis/design/point.h"

namespace pendular {

/// Readings at one or several points that together tell rivals apart.
struct Series {
    struct Step {
        std::size_t point = 0;  ///< index into the list of points
        int readings = 0;       ///< number of readings
    };
    /// In the order of increasing waiting time; empty if no allowed series tells any pair apart.
    std::vector<Step> steps;
    /// Pairs of rivals told apart at 5 % significance with a power of at least 0.8.
    std::vector<std::pair<std::size_t, std::size_t>> separated;
    double cost = 0;  ///< including refilling and waiting [cost of a dry reading]

    int readings() const;  ///< total number of readings
};

/// Returns a series of readings that tells many pairs of rivals apart at low cost, found by a
/// greedy search. The rivals i and j are told apart if D' S^-1 D, for all points together, is at
/// least `telling_noncentrality`. D is the difference of their predictions, and
///     S = V/n + J_i C_i J_i' + J_j C_j J_j' + C_f,
/// in the symbols of `separating_plans`. S contains the correlations between points: errors that
/// all points share, such as those of the parameters, do not average out.
/// @param most_readings largest number of readings in total; others as in `separating_plans`
Series separating_series(const std::vector<FittedModel>& rivals, const std::vector<Point>& points,
                         const Eigen::Vector2d& relative_noise, int most_repeats,
                         int most_readings);

}  // namespace pendular
