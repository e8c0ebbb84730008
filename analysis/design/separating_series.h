#pragma once

#include <utility>
#include <vector>

#include "analysis/design/rival.h"

namespace pendular {

/// Series of readings at one or several points (possible measurements) that together tell rival
/// models of a study apart.
struct Series {
    /// Readings of a series that are made at one point (possible measurement).
    struct Step {
        /// Index of the point in the list of possible measurements from which the series was
        /// chosen.
        std::size_t point = 0;
        /// Number of readings to make at the point.
        int readings = 0;
    };
    /// Readings at each point of the series, in the order of increasing waiting time before the
    /// readings. The list is empty if no allowed series tells any pair of rival models apart.
    std::vector<Step> steps;
    /// Pairs of rival models that the series tells apart, as indices into the list of rival models.
    /// A test at 5 % significance tells the two models of each pair apart with a probability of at
    /// least 0.8.
    std::vector<std::pair<std::size_t, std::size_t>> separated;
    /// Cost of all readings of the series, including refilling of the cell and waiting time [cost
    /// of a dry reading].
    double cost = 0;

    /// Returns the total number of readings of the series, at all points.
    int readings() const;
};

/// Returns a series of readings that tells many pairs of rival models (fitted models of one study)
/// apart at low cost, found by a greedy search. The models i and j are told apart if D' S^-1 D, for
/// all points of the series together, is at least `telling_noncentrality`. D is the difference
/// between the predictions of both models, and
///     S = V/n + J_i C_i J_i' + J_j C_j J_j' + C_f,
/// with the covariance V/n of the errors of the mean of n readings at a point, the derivatives J of
/// the predictions with respect to the parameters, the covariance C of the parameters, and the
/// covariance C_f of the simulation's errors, averaged over both models. S contains the
/// correlations between the errors at different points.
/// @param relative_noise relative standard errors [1] of the shear stress (first) and of the solid
///        fraction (second) of one reading
/// @param most_repeats largest number of readings at one point
/// @param most_readings largest number of readings in total
Series separating_series(const std::vector<Rival>& rivals, const std::vector<Point>& points,
                         const Eigen::Vector2d& relative_noise, int most_repeats,
                         int most_readings);

}  // namespace pendular
