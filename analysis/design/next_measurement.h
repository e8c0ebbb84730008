#pragma once

#include <utility>
#include <vector>

#include "analysis/design/rival.h"
#include "analysis/design/separating_series.h"
#include "data/reading.h"
#include "sim/catalogue/resolved_study.h"

namespace pendular {

/// Returns the points (possible next measurements) of a rig (the user's instrument): first readings
/// of steady shear on a grid of conditions, then direct measurements of effects' parameters
/// (without shearing grains). The grid combines normal stresses, shear rates (or inertial numbers),
/// liquid contents, volumes of beads in the cell, and waiting times before the reading. Normal
/// stresses and shear rates (or inertial numbers) are evenly spaced in the logarithm.
/// @param time time of the study's last reading [s], at which the waiting times begin
/// @throws InputError if a direct measurement of the rig is invalid (`direct_measurement`), for
///         example because the measured effect does not apply to the study
std::vector<Point> points_of(const Rig& rig, const ResolvedStudy& study, double time);

/// Returns the rig (conditions that the user's instrument can impose) of a study whose study.toml
/// has no table [rig]. The rig has the liquid contents and the ranges of normal stress and inertial
/// number of `readings`. The range of inertial numbers begins at 1e-3 if a reading has the inertial
/// number 0.
Rig rig_of(const std::vector<Reading>& readings);

/// Returns typical relative standard errors [1] of the shear stress (first) and of the solid
/// fraction (second) of one reading. Each is the root mean square, over `readings`, of the standard
/// error divided by the measured value.
Eigen::Vector2d relative_errors(const std::vector<Reading>& readings);

/// Plan of the next measurement, which is to tell rival models (fitted models of one study) apart:
/// a number of readings at one point (possible measurement), with the result that each rival model
/// predicts.
struct Plan {
    std::size_t point = 0;  ///< index of the point in the list of possible measurements
    /// Prediction of each rival model for one measurement at the point, with the covariances of its
    /// errors, in the order of the list of rival models.
    std::vector<Forecast> forecasts;
    /// Covariance matrix of the errors of one measurement at the point, in products of the units of
    /// the measured values. For a reading, the first row and column are for the shear stress [Pa],
    /// the second for the solid fraction [1]. For a direct measurement of an effect's parameter,
    /// the only entry is the variance.
    Eigen::MatrixXd noise;
    /// Number of readings to make at the point: the smallest number that tells as many pairs of
    /// rival models apart as the largest allowed number does. The number is 0 if even the largest
    /// allowed number tells no pair apart.
    int repeats = 0;
    /// Pairs of rival models that `repeats` readings tell apart, as indices into the list of rival
    /// models. A test at 5 % significance tells the two models of each pair apart with a
    /// probability of at least 0.8.
    std::vector<std::pair<std::size_t, std::size_t>> separated;
    /// Criterion T of Buzzi-Ferraris and Forzatti [1] (`separating_plans`), summed over all pairs
    /// of rival models, for the largest allowed number of readings at the point. The larger the
    /// sum, the better the readings tell the rival models apart.
    double separation = 0;
    /// Noncentrality D' S_1^-1 D [1] (symbols: `separating_plans`) of the chi2 test that tells two
    /// rival models apart, summed over all pairs of rival models, for the largest allowed number of
    /// readings at the point. The sum ranks the points if no allowed number of readings tells any
    /// pair apart.
    double noncentrality = 0;
    /// Cost of `repeats` readings at the point, including refilling of the cell and waiting time
    /// [cost of a dry reading]. If `repeats` is 0, `cost` is the cost of one reading.
    double cost = 0;
};

/// Returns a plan of readings for each of `points` (possible measurements), the best plan first.
/// Plans that tell more pairs of rival models (fitted models of one study) apart are better. Among
/// plans that tell equally many pairs apart, cheaper plans are better. Among equally cheap plans,
/// plans of larger criterion T are better. For n readings at a point and the rival models i and j,
///     T = D' S^-1 D + tr(2 V S^-1)/n,   D = f_i - f_j,
///     S = 2 V/n + J_i C_i J_i' + J_j C_j J_j' + 2 C_f,
/// with the predicted values f, the derivatives J of the predicted values with respect to the
/// parameters, the covariance C of the parameters, the covariance V of the errors of one reading,
/// and the covariance C_f of the simulation's errors, averaged over both models. A pair is told
/// apart if D' S_1^-1 D is at least `telling_noncentrality`, or `telling_directly` for a direct
/// measurement. S_1 is S with V/n and C_f once instead of twice.
/// @param relative_noise relative standard errors [1] of the shear stress (first) and of the solid
///        fraction (second) of one reading
/// @param most_repeats largest number of readings at one point
/// Source: Buzzi-Ferraris and Forzatti, Chem. Eng. Sci. 38 (1983) 225.
std::vector<Plan> separating_plans(const std::vector<Rival>& rivals,
                                   const std::vector<Point>& points,
                                   const Eigen::Vector2d& relative_noise, int most_repeats);

/// Returns the readings to make next in order to tell rival models (fitted models of one study)
/// apart: the readings of the best plan, the first of `plans`. If a series of readings at several
/// points (`separating_series`) tells more pairs of rival models apart, the function returns this
/// series instead. The result has no readings if neither tells any pair apart.
/// @param plans plans for `points` in the order of `separating_plans`; at least one plan
/// @param relative_noise relative standard errors [1] of the shear stress (first) and of the solid
///        fraction (second) of one reading
/// @param rig instrument, which states the largest number of readings at one point and in total
Series next_series(const std::vector<Plan>& plans, const std::vector<Rival>& rivals,
                   const std::vector<Point>& points, const Eigen::Vector2d& relative_noise,
                   const Rig& rig);

/// Expected standard errors of a model's fitted parameters after further readings at one point
/// (possible next measurement).
struct Sharpening {
    std::size_t point = 0;  ///< index of the point in the list of possible measurements
    /// Values that the model predicts for one measurement at the point, with the covariances of
    /// their errors.
    Forecast forecast;
    /// Standard errors that the model's parameters are expected to have after the readings at the
    /// point, in the order and units of the parameters.
    Eigen::VectorXd standard_errors;
    /// Gain in precision per cost [1/cost of a dry reading]: sum over the parameters of ln(standard
    /// error before the readings/standard error after the readings), divided by the cost of the
    /// readings.
    double gain = 0;
};

/// Returns, for each of `points` (possible measurements), the standard errors that the fitted
/// parameters of `model` are expected to have after n = `repeats` further readings at the point.
/// The results are sorted by `Sharpening::gain`, the largest first. The covariance C of the
/// parameters becomes
///     C' = (C^-1 + J' (V/n + C_f)^-1 J)^-1
/// with the covariance V of the errors of one reading, the covariance C_f of the simulation's
/// errors, and the derivatives J of the predicted values with respect to the parameters.
/// @param relative_noise relative standard errors [1] of the shear stress (first) and of the solid
///        fraction (second) of one reading
std::vector<Sharpening> sharpening_plans(const Rival& model, const std::vector<Point>& points,
                                         const Eigen::Vector2d& relative_noise, int repeats);

}  // namespace pendular
