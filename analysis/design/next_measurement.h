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
/// @throws InputError if a direct measurement names an effect that is unknown, has no parameter or
///         does not apply to the study, or if it has a wrong unit
std::vector<Point> points_of(const Rig& rig, const ResolvedStudy& study, double time);

/// Returns the rig (possible measurements of an instrument) of a study whose study.toml has no
/// table [rig]. It has the ranges of normal stress and inertial number, and the liquid contents, of
/// `readings`. The range of inertial numbers begins at 1e-3 if a reading has inertial number 0.
Rig rig_of(const std::vector<Reading>& readings);

/// Typical relative standard errors of the shear stress and the solid fraction of one reading [1],
/// in this order: root mean square over `readings` of standard error divided by measured value.
Eigen::Vector2d relative_errors(const std::vector<Reading>& readings);

/// Expected result of readings at one point (possible next measurement) that are made to find out
/// which of several rival models is right.
struct Plan {
    std::size_t point = 0;  ///< index into the list of points that were compared
    /// For each rival model, its prediction for a measurement at the point, with errors, in the
    /// order of the list of rivals.
    std::vector<Forecast> forecasts;
    /// Covariance of the errors of one measurement at the point: of shear stress [Pa] and solid
    /// fraction [1], or variance of the one value of a direct measurement.
    Eigen::MatrixXd noise;
    /// Number of readings to make at the point. It is the smallest number that separates (tells
    /// apart) as many pairs of rival models as the largest number allowed; 0: not even the largest
    /// number separates a pair.
    int repeats = 0;
    /// Pairs of rival models, as indices into the list of rivals, that `repeats` readings tell
    /// apart: with a probability of 0.8, a test at 5 % significance distinguishes both models.
    std::vector<std::pair<std::size_t, std::size_t>> separated;
    /// Criterion T of Buzzi-Ferraris and Forzatti (see `separating_plans`) for telling rival models
    /// apart, summed over all pairs of rivals, at the largest number of readings allowed [1].
    double separation = 0;
    /// Noncentrality of the chi2 test that tells two rival models apart, D' S_1^-1 D (see
    /// `separating_plans`), summed over all pairs of rivals, at the largest number of readings
    /// allowed [1].
    double noncentrality = 0;
    /// Cost of `repeats` readings at the point (of one reading if `repeats` is 0), with filling and
    /// waiting [cost of a dry reading].
    double cost = 0;
};

/// Returns a plan for each of `points` (possible measurements), sorted by how well readings at the
/// point tell rival models apart: plans that separate more pairs of rivals first, then cheaper
/// plans, then plans of larger criterion T. For n readings at a point and rivals i and j,
///     T = D' S^-1 D + tr(2 V S^-1)/n,   D = f_i - f_j,
///     S = 2 V/n + J_i C_i J_i' + J_j C_j J_j' + 2 C_f,
/// with the predicted values f, their derivatives J with respect to the parameters, the covariance
/// C of the parameters, the covariance V of one reading and the covariance C_f of the simulation's
/// errors, which both rivals share. A pair is separated if D' S_1^-1 D reaches
/// `telling_noncentrality`, or `telling_directly` for a direct measurement. S_1 contains V/n and
/// C_f once instead of twice, since both rivals are compared with one measurement.
/// @param relative_noise relative standard errors of the shear stress and the solid fraction of one
///        reading, in this order [1]
/// @param most_repeats largest number of readings at one point
/// Source: Buzzi-Ferraris and Forzatti, Chem. Eng. Sci. 38 (1983) 225.
std::vector<Plan> separating_plans(const std::vector<Rival>& rivals,
                                   const std::vector<Point>& points,
                                   const Eigen::Vector2d& relative_noise, int most_repeats);

/// Returns the readings to make next in order to tell rival models apart. These are the readings of
/// the first of `plans` or, if it separates more pairs of rivals, a series of readings at several
/// points (`separating_series`).
/// @param plans plans for `points` as `separating_plans` sorts them, at least one
/// @param relative_noise relative standard errors of the shear stress and the solid fraction of one
///        reading, in this order [1]
/// @param rig instrument, which limits the number of readings at one point and in total
Series next_series(const std::vector<Plan>& plans, const std::vector<Rival>& rivals,
                   const std::vector<Point>& points, const Eigen::Vector2d& relative_noise,
                   const Rig& rig);

/// Expected standard errors of a model's fitted parameters after further readings at one point.
struct Sharpening {
    std::size_t point = 0;  ///< index into the list of points that were compared
    /// Values that the model predicts for a measurement at the point, with their errors.
    Forecast forecast;
    /// Standard errors of the model's parameters that are expected after the readings at the point,
    /// in the order and units of the parameters.
    Eigen::VectorXd standard_errors;
    /// Gain in precision: sum over the parameters of ln(standard error before/after the readings),
    /// divided by the cost of the readings [1/cost of a dry reading].
    double gain = 0;
};

/// Returns how precisely the parameters of `model` are expected to be known after `repeats` further
/// readings, for each of `points` (possible measurements), sorted by `Sharpening::gain`, the
/// largest first. The covariance C of the parameters becomes
///     C' = (C^-1 + J' (V/n + C_f)^-1 J)^-1
/// with the number n of readings, the covariance V of one reading, the covariance C_f of the
/// simulation's errors and the derivatives J of the predicted values with respect to the
/// parameters.
/// @param relative_noise relative standard errors of the shear stress and the solid fraction of one
///        reading, in this order [1]
std::vector<Sharpening> sharpening_plans(const Rival& model, const std::vector<Point>& points,
                                         const Eigen::Vector2d& relative_noise, int repeats);

}  // namespace pendular
