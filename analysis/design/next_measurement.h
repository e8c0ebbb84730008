#pragma once

#include <utility>
#include <vector>

#include "analysis/design/rival.h"
#include "analysis/design/separating_series.h"
#include "data/reading.h"
#include "sim/catalogue/resolved_study.h"

namespace pendular {

/// Points at which a rig (the user's instrument) can measure: a grid of conditions, followed by the
/// rig's direct measurements. The grid combines normal stresses and rates, evenly spaced in the
/// logarithm, with every liquid content, every filling (volume of beads in the cell) and every
/// waiting time after `time`, the time of the last reading [s].
/// @throws InputError where a direct measurement names an effect that is unknown, has no parameter
///         or does not apply to the study, or has a wrong unit
std::vector<Point> points_of(const Rig& rig, const ResolvedStudy& study, double time);

/// Rig (possible measurements of an instrument) for a study.toml without [rig]: with the ranges of
/// normal stress and inertial number, and the liquid contents, of `readings`. A range of inertial
/// numbers that begins at 0 begins at 1e-3 instead.
Rig rig_of(const std::vector<Reading>& readings);

/// Typical relative standard errors of one reading, for (shear stress, solid fraction) [1]: the
/// root mean square over `readings` of standard error over measured value.
Eigen::Vector2d relative_errors(const std::vector<Reading>& readings);

/// Expected result of measuring at one point, to find out which of several rival models is right.
struct Plan {
    std::size_t point = 0;  ///< index into the list of points to choose from
    /// Values that each rival model predicts at the point, in the order of the rivals.
    std::vector<Forecast> forecasts;
    Eigen::MatrixXd noise;  ///< covariance of the measured values of one reading
    /// Smallest number of readings at the point that separates as many pairs of rivals as the
    /// largest number allowed; 0: the point separates no pair.
    int repeats = 0;
    /// Pairs of rivals, as indices into the list of rivals, that `repeats` readings at the point
    /// separate (tell apart by a significance test).
    std::vector<std::pair<std::size_t, std::size_t>> separated;
    /// Criterion T of `separating_plans`, summed over pairs of rivals, at the largest number of
    /// readings allowed [1].
    double separation = 0;
    /// Noncentrality D' S_1^-1 D of `separating_plans`, summed over pairs of rivals, at the largest
    /// number of readings allowed [1].
    double noncentrality = 0;
    /// Cost of `repeats` readings, at least one, with filling and waiting [cost of a dry reading].
    double cost = 0;
};

/// One plan for each point at which rival models may be told apart, sorted: plans that separate
/// more pairs of rivals first, then cheaper plans, then plans of larger T. With n readings of
/// covariance V/n and rivals i and j,
///     T = D' S^-1 D + tr(2 V S^-1)/n,   D = f_i - f_j,
///     S = 2 V/n + J_i C_i J_i' + J_j C_j J_j' + 2 C_f,
/// f: forecasts, J and C: derivatives by the parameters and covariance of the parameters, C_f:
/// covariance of the simulation, whose errors both rivals share. A pair is separated where
/// D' S_1^-1 D reaches `telling_noncentrality`, or `telling_directly` for a direct measurement; S_1
/// has V/n and C_f only once, since both rivals are compared with one measurement.
/// @param relative_noise standard errors of (shear stress, solid fraction) of one reading, over
///        their values [1]
/// @param most_repeats largest number of readings at one point
/// Source: Buzzi-Ferraris and Forzatti, Chem. Eng. Sci. 38 (1983) 225.
std::vector<Plan> separating_plans(const std::vector<Rival>& rivals,
                                   const std::vector<Point>& points,
                                   const Eigen::Vector2d& relative_noise, int most_repeats);

/// Readings to make next, to tell rival models apart: those of the first of `plans`, in the order
/// of `separating_plans`; or a series of readings at several points, if the series separates more
/// pairs of rivals. `rig` limits the readings at one point and in total.
Series next_series(const std::vector<Plan>& plans, const std::vector<Rival>& rivals,
                   const std::vector<Point>& points, const Eigen::Vector2d& relative_noise,
                   const Rig& rig);

/// Expected standard errors of a model's fitted parameters after further readings at one point.
struct Sharpening {
    std::size_t point = 0;  ///< index into the list of points to choose from
    Forecast forecast;      ///< values that the model predicts at the point
    /// Standard errors expected after the readings, in the order and units of the parameters.
    Eigen::VectorXd standard_errors;
    /// Sum over the parameters of ln(standard error before/after), divided by the cost in dry
    /// readings.
    double gain = 0;
};

/// Expected standard errors of the fitted parameters of `model` after `repeats` readings at each
/// point, sorted by `Sharpening::gain`, the largest first. The covariance C of the parameters
/// becomes
///     C' = (C^-1 + J' (V/n + C_f)^-1 J)^-1,
/// n: number of readings, V: covariance of one reading, C_f: covariance of the simulation's errors,
/// J: derivatives of the predicted values by the parameters.
/// @param relative_noise standard errors of (shear stress, solid fraction) of one reading, over
///        their values [1]
std::vector<Sharpening> sharpening_plans(const Rival& model, const std::vector<Point>& points,
                                         const Eigen::Vector2d& relative_noise, int repeats);

}  // namespace pendular
