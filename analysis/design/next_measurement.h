#pragma once

#include <utility>
#include <vector>

#include "analysis/design/rival.h"
#include "analysis/design/separating_series.h"
#include "data/reading.h"
#include "sim/catalogue/resolved_study.h"

namespace pendular {

/// Returns the measurements that a rig (the user's instrument) can make: a grid of conditions for
/// readings of steady shear, followed by the rig's direct measurements. The grid combines normal
/// stresses and shear rates (or inertial numbers), evenly spaced in the logarithm, with every
/// liquid content, every filling (volume of beads in the cell) and every waiting time.
/// @param time time of the study's last reading [s], at which the waiting times begin
/// @throws InputError where a direct measurement names an effect that is unknown, has no parameter
///         or does not apply to the study, or has a wrong unit
std::vector<Point> points_of(const Rig& rig, const ResolvedStudy& study, double time);

/// Returns the rig (possible measurements of an instrument) of a study whose study.toml has no
/// table [rig]. It has the ranges of normal stress and inertial number, and the liquid contents, of
/// `readings`. The range of inertial numbers begins at 1e-3 where a reading has inertial number 0.
Rig rig_of(const std::vector<Reading>& readings);

/// Typical relative standard errors (shear stress, solid fraction) of one reading [1]: root mean
/// square over `readings` of standard error over measured value.
Eigen::Vector2d relative_errors(const std::vector<Reading>& readings);

/// Expected result of measuring at one point, to find out which of several rival models is right.
struct Plan {
    std::size_t point = 0;  ///< index into the list of points that were compared
    /// Prediction of each rival model at the point with its errors, in the order of the rivals.
    std::vector<Forecast> forecasts;
    /// Covariance of the measurement errors of the values of one measurement at the point, in their
    /// squared units.
    Eigen::MatrixXd noise;
    /// Smallest number of readings at the point that separates as many pairs of rivals as the
    /// largest number allowed would; 0: the point separates no pair.
    int repeats = 0;
    /// Pairs of rivals, as indices into the list of rivals, that `repeats` readings separate: a
    /// test at 5 % significance tells them apart with a probability of 0.8.
    std::vector<std::pair<std::size_t, std::size_t>> separated;
    /// Criterion T of `separating_plans`, summed over all pairs of rivals, at the largest number of
    /// readings allowed [1].
    double separation = 0;
    /// Noncentrality D' S_1^-1 D of `separating_plans`, summed over all pairs of rivals, at the
    /// largest number of readings allowed [1].
    double noncentrality = 0;
    /// Cost of `repeats` readings at the point (of one reading if `repeats` is 0), with filling and
    /// waiting [cost of a dry reading].
    double cost = 0;
};

/// Returns a plan for each of `points`, sorted by how well readings there tell rival models apart:
/// plans that separate more pairs of rivals first, then cheaper plans, then plans of larger
/// criterion T. For n readings at a point and rivals i and j,
///     T = D' S^-1 D + tr(2 V S^-1)/n,   D = f_i - f_j,
///     S = 2 V/n + J_i C_i J_i' + J_j C_j J_j' + 2 C_f,
/// with the predicted values f, their derivatives J with respect to the parameters, the covariance
/// C of the parameters, the covariance V of one reading and the covariance C_f of the simulation's
/// errors, which both rivals share. A pair is separated where D' S_1^-1 D reaches
/// `telling_noncentrality`, or `telling_directly` for a direct measurement; S_1 is S with V/n and
/// C_f only once, since both rivals are compared with one measurement.
/// @param relative_noise standard errors of (shear stress, solid fraction) of one reading, over
///        their values [1]
/// @param most_repeats largest number of readings at one point
/// Source: Buzzi-Ferraris and Forzatti, Chem. Eng. Sci. 38 (1983) 225.
std::vector<Plan> separating_plans(const std::vector<Rival>& rivals,
                                   const std::vector<Point>& points,
                                   const Eigen::Vector2d& relative_noise, int most_repeats);

/// Returns the readings to make next in order to tell rival models apart: those of the first of
/// `plans` or, if more pairs of rivals are separated by it, a series of readings at several points
/// (`separating_series`).
/// @param plans plans for `points` as `separating_plans` sorts them, at least one
/// @param relative_noise standard errors of (shear stress, solid fraction) of one reading, over
///        their values [1]
/// @param rig instrument, which limits the number of readings at one point and in total
Series next_series(const std::vector<Plan>& plans, const std::vector<Rival>& rivals,
                   const std::vector<Point>& points, const Eigen::Vector2d& relative_noise,
                   const Rig& rig);

/// Expected standard errors of a model's fitted parameters after further readings at one point.
struct Sharpening {
    std::size_t point = 0;  ///< index into the list of points that were compared
    /// Values that the model predicts at the point, with their errors.
    Forecast forecast;
    /// Standard errors of the model's parameters that are expected after the readings at the point,
    /// in the order and units of the parameters.
    Eigen::VectorXd standard_errors;
    /// Gain in precision: sum over the parameters of ln(standard error before/after the readings),
    /// divided by the cost of the readings [1/cost of a dry reading].
    double gain = 0;
};

/// Returns the expected standard errors of the fitted parameters of `model` after `repeats`
/// readings, for each of `points`, sorted by `Sharpening::gain`, the largest first. The covariance
/// C of the parameters becomes
///     C' = (C^-1 + J' (V/n + C_f)^-1 J)^-1
/// with the number n of readings, the covariance V of one reading, the covariance C_f of the
/// simulation's errors and the derivatives J of the predicted values with respect to the
/// parameters.
/// @param relative_noise standard errors of (shear stress, solid fraction) of one reading, over
///        their values [1]
std::vector<Sharpening> sharpening_plans(const Rival& model, const std::vector<Point>& points,
                                         const Eigen::Vector2d& relative_noise, int repeats);

}  // namespace pendular
