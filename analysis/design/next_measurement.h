#pragma once

#include <utility>
#include <vector>

#include "analysis/design/point.h"
#include "analysis/design/separating_series.h"
#include "data/reading.h"
#include "sim/catalogue/resolved_study.h"

namespace pendular {

/// Returns the possible measurements of a rig: readings on a grid of normal stresses and shear
/// rates (or inertial numbers), both evenly spaced in the logarithm, liquid contents, bead volumes
/// and waiting times; then direct measurements.
/// @param time time of the study's last reading [s], at which the waiting times begin
/// @throws InputError if a direct measurement is invalid (`direct_measurement`), for example
///         because its effect does not apply to the study
std::vector<Point> points_of(const Rig& rig, const ResolvedStudy& study, double time);

/// Returns the rig of a study without a table [rig]: the liquid contents and the ranges of normal
/// stress and inertial number of `readings`. The inertial numbers begin at 1e-3 if a reading has
/// the inertial number 0, since the grid is logarithmic.
Rig rig_of(const std::vector<Reading>& readings);

/// Returns the relative standard errors [1] of shear stress and solid fraction of a typical
/// reading: root mean square, over `readings`, of standard error over measured value.
Eigen::Vector2d relative_errors(const std::vector<Reading>& readings);

/// Readings at one point that are to tell rival models apart (`separating_plans`).
struct Plan {
    std::size_t point = 0;            ///< index into the list of points
    std::vector<Forecast> forecasts;  ///< prediction of each rival for one measurement
    /// Covariance of the errors of one measurement, in products of the units of its values: shear
    /// stress [Pa] and solid fraction [1], or the parameter of a direct measurement.
    Eigen::MatrixXd noise;
    /// Smallest number of readings that tells as many pairs apart as the largest allowed number; 0
    /// if even this number tells no pair apart.
    int repeats = 0;
    /// Pairs of rivals that `repeats` readings tell apart at 5 % significance with a power of at
    /// least 0.8.
    std::vector<std::pair<std::size_t, std::size_t>> separated;
    double separation = 0;  ///< sum of T [1] over all pairs, for the most readings
    /// Sum of D' S_1^-1 D [1] over all pairs for the most readings. Ranks the points if no number
    /// of readings tells any pair apart.
    double noncentrality = 0;
    /// Cost of `repeats` readings (of one, if `repeats` is 0) with refilling and waiting [cost of a
    /// dry reading].
    double cost = 0;
};

/// Returns a plan for each point, the best first: the most pairs of rivals told apart, then the
/// lowest cost, then the largest criterion T. For n readings at a point and the rivals i and j,
///     T = D' S^-1 D + tr(2 V S^-1)/n,   D = f_i - f_j,
///     S = 2 V/n + J_i C_i J_i' + J_j C_j J_j' + 2 C_f,
/// with the predictions f, their derivatives J with respect to the parameters, the covariances C of
/// the parameters, V of one reading, and C_f of the simulation (mean of both rivals). A pair is
/// told apart if D' S_1^-1 D is at least `telling_noncentrality`, or `telling_directly` for a
/// direct measurement. S_1 is S with V/n and C_f once instead of twice.
/// @param relative_noise relative standard errors [1] of shear stress and solid fraction of a
///        reading
/// @param most_repeats largest number of readings at one point
/// Source: Buzzi-Ferraris and Forzatti, Chem. Eng. Sci. 38 (1983) 225.
std::vector<Plan> separating_plans(const std::vector<FittedModel>& rivals,
                                   const std::vector<Point>& points,
                                   const Eigen::Vector2d& relative_noise, int most_repeats);

/// Returns the readings to make next: those of the first of `plans` or, if it tells more pairs
/// apart, a series at several points (`separating_series`). No readings if neither tells any pair
/// apart.
/// @param plans result of `separating_plans` for `points`; not empty
Series next_series(const std::vector<Plan>& plans, const std::vector<FittedModel>& rivals,
                   const std::vector<Point>& points, const Eigen::Vector2d& relative_noise,
                   const Rig& rig);

/// Expected standard errors of a model's parameters after further readings at one point.
struct Sharpening {
    std::size_t point = 0;            ///< index into the list of points
    Forecast forecast;                ///< prediction for one measurement
    Eigen::VectorXd standard_errors;  ///< in the order and units of the parameters
    /// Sum over the parameters of ln(standard error before/after), over the cost of the readings
    /// [1/cost of a dry reading].
    double gain = 0;
};

/// Returns the standard errors of the parameters of `model` after n = `repeats` further readings at
/// each point, sorted by `Sharpening::gain`, the largest first. The covariance C of the parameters
/// becomes
///     C' = (C^-1 + J' (V/n + C_f)^-1 J)^-1
/// in the symbols of `separating_plans`.
std::vector<Sharpening> sharpening_plans(const FittedModel& model, const std::vector<Point>& points,
                                         const Eigen::Vector2d& relative_noise, int repeats);

}  // namespace pendular
