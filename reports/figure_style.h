#pragma once

#include <array>
#include <string>
#include <vector>

#include "calib/fit/calibration.h"
#include "reports/figure.h"
#include "sim/catalogue/effect.h"

namespace pendular {

// Parts that the figures share: labels of axes, colours, and values of readings as they are drawn.

inline const std::string stress_ratio_label = "stress ratio μ* = |σ_{12}|/σ_{22}";
inline const std::string solid_fraction_label = "solid fraction Φ_S";
inline const std::string measured_colour = "#1b1b1b", model_colour = "#0b62a4",
                         calibrated_colour = "#c0392b", run_colour = "#5b9bd5",
                         explaining_colour =
                             "#606060";  ///< colour of key (legend) entries common to all series

/// Stress ratio [1] and solid fraction [1] of a reading or of a prediction, in this order, with
/// their standard errors, as figures draw them.
struct Shown {
    std::array<double, 2> value, error;
};
/// Returns the measured stress ratio [1] and solid fraction [1] of a reading (averages over one
/// step of steady shear, or a point of failure), with their standard errors.
Shown shown(const Reading& reading);

/// Returns the predicted stress ratio [1] and solid fraction [1] at the condition of one reading,
/// with their standard errors.
/// @param place index of the reading in `predicted`
/// @param normal_stress normal stress of the reading [Pa], by which the shear stress is divided
Shown shown(const Prediction& predicted, Eigen::Index place, double normal_stress);

/// Returns the weighted mean of several stress ratios [1] and of several solid fractions [1], with
/// the weights 1/(standard error)^2. The standard errors of the means hold if the errors of the
/// averaged values are independent.
Shown mean_of(const std::vector<Shown>& all);

/// Means of the stress ratio [1] and the solid fraction [1] over some readings: means of the
/// measured values (`measured`), and of the values that the model predicts (`model`).
struct MeasuredAndModel {
    Shown measured, model;
};
/// Returns the means of the measured and of the predicted stress ratio [1] and solid fraction [1]
/// over some readings of a calibration. The weight of a reading in all means is 1/(standard error
/// of the measured value)^2. The standard errors contain what readings share.
/// @param places indices of these readings in `calibration.readings`
/// @param covariance covariance of the measured values of all readings
MeasuredAndModel means_of(const std::vector<std::size_t>& places, const Calibration& calibration,
                          const Eigen::MatrixXd& covariance);

/// Whether a figure may draw one point, the mean prediction, in place of the predictions of several
/// readings. True if the predicted stress ratio and solid fraction of each reading differ from the
/// mean predictions for these readings by at most `same_point` standard errors of the measured
/// values.
/// @param places indices of these readings in `calibration.readings`
bool mean_suffices(const std::vector<std::size_t>& places, const Calibration& calibration);

/// Largest allowed difference between the prediction of a reading and the mean or curve that a
/// figure draws in place of this prediction, divided by the standard error of the measured value
/// [1].
constexpr double same_point = 0.25;

/// Adds a point with an error bar of one standard error to a curve.
/// @param x position along the x axis
/// @param o quantity that is drawn as y: 0 for the stress ratio in `shown`, 1 for the solid
///        fraction
void add_point(Curve& curve, double x, const Shown& shown, std::size_t o);

/// Returns a text that names effects in the title or key of a figure: "lid-slip", "lid-slip and
/// torque-offset" or "3 effects". The text is empty if there is no effect.
std::string names_of(const std::vector<const Effect*>& effects);

/// Whether values suit a logarithmic axis: all are positive, and the greatest is more than 10 times
/// the least.
bool spans_decade(const std::vector<double>& values);

/// Returns the text of an inertial number in a figure: "I = 0.003", or "I → 0" for the quasi-static
/// limit 0.
std::string inertial_text(double inertial_number);

}  // namespace pendular
