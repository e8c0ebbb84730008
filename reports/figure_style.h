#pragma once

#include <array>
#include <string>
#include <vector>

#include "calib/fit/calibration.h"
#include "reports/figure.h"
#include "sim/catalogue/effect.h"

namespace pendular {

// What the figures share: names of axes, colours, and how readings are shown.

inline const std::string stress_ratio_label = "stress ratio μ* = |σ_{12}|/σ_{22}";
inline const std::string solid_fraction_label = "solid fraction Φ_S";
inline const std::string measured_colour = "#1b1b1b", model_colour = "#0b62a4",
                         calibrated_colour = "#c0392b", run_colour = "#5b9bd5",
                         explaining_colour =
                             "#606060";  ///< colour of key entries that concern all data

/// (stress ratio, solid fraction) with their standard errors.
struct Shown {
    std::array<double, 2> value, error;
};
Shown shown(const Reading& reading);

/// Prediction of a reading with its standard errors, at a place of the prediction; normal stress in
/// Pa.
Shown shown(const Prediction& predicted, Eigen::Index place, double normal_stress);

/// Mean weighted by the standard errors, where one value stands for several.
Shown mean_of(const std::vector<Shown>& all);

/// Measured and predicted values of some readings of a calibration, by their places: the mean of
/// either with the weights of the readings.
struct MeasuredAndModel {
    Shown measured, model;
};
MeasuredAndModel means_of(const std::vector<std::size_t>& places, const Calibration& calibration);

/// Whether the mean prediction of these readings represents each of them, within `told_apart`
/// standard errors.
bool told_by_mean(const std::vector<std::size_t>& places, const Calibration& calibration);

/// Predictions that differ by less, in standard errors of a reading, are drawn as one [1].
constexpr double told_apart = 0.25;

/// Adds a point of observable `o` to a curve.
void add_point(Curve& curve, double x, const Shown& shown, std::size_t o);

/// "lid-slip", "lid-slip and torque-offset", "3 effects": effects in a title or a key.
std::string names_of(const std::vector<const Effect*>& effects);

/// Whether values span more than a decade and none of them is zero.
bool spans_decade(const std::vector<double>& values);

/// Inertial number as text in a figure.
std::string inertial_text(double inertial_number);

}  // namespace pendular
