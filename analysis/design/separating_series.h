#pragma once

#include <utility>
#include <vector>

#include "analysis/design/rival.h"

namespace pendular {

/// Readings at one or several points that together separate rivals.
struct Series {
    struct Step {
        std::size_t point = 0;
        int readings = 0;
    };
    std::vector<Step> steps;  ///< the longest waits last; empty where these readings are too few
    std::vector<std::pair<std::size_t, std::size_t>> separated;  ///< pairs of rivals
    double cost = 0;

    int readings() const;
};

/// A cheap series that tells as many pairs of rivals apart as it can with so many readings. Rivals
/// are told apart where D' S^-1 D of all points together, D their differences and
///     S = V/n + J_i C_i J_i' + J_j C_j J_j' + C_f,
/// reaches `telling_noncentrality`; what points share by errors of the parameters or the simulation
/// is no news at the second of them. Found one reading at a time, each where it brings pairs that
/// are not yet told apart on most, over its cost; readings that then are not needed are left out.
Series separating_series(const std::vector<Rival>& rivals, const std::vector<Point>& points,
                         const Eigen::Vector2d& relative_noise, int most_repeats,
                         int most_readings);

}  // namespace pendular
