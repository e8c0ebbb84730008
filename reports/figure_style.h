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
                             "#606060";  ///< colour of key entries that explain all series of data

/// Values as figures show them: (stress ratio [1], solid fraction [1]) with their standard errors.
struct Shown {
    std::array<double, 2> value, error;
};
/// Measured stress ratio and solid fraction of a reading.
Shown shown(const Reading& reading);

/// Predicted stress ratio and solid fraction of the reading with index `place`, at its normal
/// stress [Pa].
Shown shown(const Prediction& predicted, Eigen::Index place, double normal_stress);

/// Mean of several values, weighted by 1/standard error^2. Its error holds for independent values.
Shown mean_of(const std::vector<Shown>& all);

/// Means of the measured and of the predicted values of some readings.
struct MeasuredAndModel {
    Shown measured, model;
};
/// Means over the readings of a calibration with indices `places`. Both means have the weights
/// 1/standard error^2 of the measured values.
MeasuredAndModel means_of(const std::vector<std::size_t>& places, const Calibration& calibration);

/// Whether the predictions of all readings with indices `places` agree with their mean prediction,
/// within `told_apart` standard errors of the reading. A figure then shows the mean alone.
bool told_by_mean(const std::vector<std::size_t>& places, const Calibration& calibration);

/// Difference of two predictions, in standard errors of a reading, below which figures draw them as
/// one [1].
constexpr double told_apart = 0.25;

/// Adds a point at `x` to a curve: observable `o`, 0 for the stress ratio and 1 for the solid
/// fraction, with its standard error.
void add_point(Curve& curve, double x, const Shown& shown, std::size_t o);

/// Text for effects in a title or a key: "lid-slip", "lid-slip and torque-offset", "3 effects".
std::string names_of(const std::vector<const Effect*>& effects);

/// Whether all values are positive and span more than a decade, so that a logarithmic axis suits.
bool spans_decade(const std::vector<double>& values);

/// Text of an inertial number in a figure: "I = 0.003", or "I → 0" for the quasi-static limit 0.
std::string inertial_text(double inertial_number);

}  // namespace pendular
