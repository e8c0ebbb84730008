#pragma once

#include <utility>
#include <vector>

#include "analysis/design/rival.h"
#include "analysis/design/separating_series.h"
#include "data/reading.h"
#include "sim/catalogue/resolved_study.h"

namespace pendular {

/// Conditions that a rig can be set to, on a grid: normal stresses and rates in even steps of their
/// logarithm, every liquid content and filling, after every wait from `time` [s] on; and then what
/// can be measured directly.
/// @throws InputError for a direct measurement that the study's effects do not know
std::vector<Point> points_of(const Rig& rig, const ResolvedStudy& study, double time);

/// Rig of a study without [rig]: the range of its readings.
Rig rig_of(const std::vector<Reading>& readings);

/// Standard errors of one reading, shear stress and solid fraction, over the values: the root mean
/// square of those that were made.
Eigen::Vector2d relative_errors(const std::vector<Reading>& readings);

/// Expected result of measuring at one point.
struct Plan {
    std::size_t point = 0;
    std::vector<Forecast> forecasts;  ///< forecast of each rival
    Eigen::MatrixXd noise;            ///< covariance of one reading
    /// Smallest number of readings that separates as many rivals as this point can; 0: it separates
    /// none.
    int repeats = 0;
    /// Pairs of rivals that these readings separate.
    std::vector<std::pair<std::size_t, std::size_t>> separated;
    double separation = 0;     ///< criterion below, summed over pairs, at the most readings allowed
    double noncentrality = 0;  ///< D' S_1^-1 D below, at the most readings allowed
    double cost = 0;
};

/// Plans of all points, the most telling first. With n readings of covariance V/n, rivals i and j,
///     T = D' S^-1 D + tr(2 V S^-1)/n,   D = f_i - f_j,
///     S = 2 V/n + J_i C_i J_i' + J_j C_j J_j' + 2 C_f,
/// C_f of the simulation, whose errors both share. They are told apart where D' S_1^-1 D with only
/// one V/n and C_f in S_1, since one measurement faces both, reaches `telling_noncentrality`, or
/// `telling_directly`.
/// First come plans that separate more pairs, then cheaper ones, then those of larger T.
/// `relative_noise`: standard errors of one reading, over the values.
/// Source: Buzzi-Ferraris and Forzatti, Chem. Eng. Sci. 38 (1983) 225.
std::vector<Plan> separating_plans(const std::vector<Rival>& rivals,
                                   const std::vector<Point>& points,
                                   const Eigen::Vector2d& relative_noise, int most_repeats);

/// Measurements to make: the point of the first plan alone, or a series where that separates more
/// pairs apart. Of a rig: repeats at one point, readings in all.
Series next_series(const std::vector<Plan>& plans, const std::vector<Rival>& rivals,
                   const std::vector<Point>& points, const Eigen::Vector2d& relative_noise,
                   const Rig& rig);

/// Expected standard errors of a model's parameters after a number of readings at one point.
struct Sharpening {
    std::size_t point = 0;
    Forecast forecast;
    Eigen::VectorXd standard_errors;  ///< expected standard errors of the parameters
    double gain = 0;  ///< sum over parameters of ln(standard error before/after), per cost
};

/// Sharpening at all points, the largest gain first:
///     C' = (C^-1 + J' (V/n + C_f)^-1 J)^-1.
std::vector<Sharpening> sharpening_plans(const Rival& model, const std::vector<Point>& points,
                                         const Eigen::Vector2d& relative_noise, int repeats);

}  // namespace pendular
