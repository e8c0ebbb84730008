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

/// Values of one reading or prediction as figures show them: (stress ratio [1], solid fraction [1])
/// with their standard errors.
struct Shown {
    std::array<double, 2> value, error;
};
/// Measured stress ratio [1] and solid fraction [1] of a reading, with their standard errors.
Shown shown(const Reading& reading);

/// Predicted stress ratio [1] and solid fraction [1], with their standard errors, of the reading
/// with index `place` in `predicted`. `normal_stress`: normal stress of this reading [Pa].
Shown shown(const Prediction& predicted, Eigen::Index place, double normal_stress);

/// Means of several stress ratios and solid fractions, weighted by 1/standard error^2. The standard
/// errors of the means hold for independent values.
Shown mean_of(const std::vector<Shown>& all);

/// Means over some readings of the measured and of the predicted stress ratio and solid fraction.
struct MeasuredAndModel {
    Shown measured, model;
};
/// Means of measured and of predicted stress ratio and solid fraction, over the readings of a
/// calibration with indices `places`. All weights are 1/standard error^2 of the measured values.
MeasuredAndModel means_of(const std::vector<std::size_t>& places, const Calibration& calibration);

/// Whether the predicted stress ratio and solid fraction of each reading with an index in `places`
/// agree with the mean prediction of these readings, within `told_apart` standard errors of the
/// reading. Where they agree, a figure shows the mean alone.
bool told_by_mean(const std::vector<std::size_t>& places, const Calibration& calibration);

/// Difference between two predictions, in standard errors of a measured reading [1], up to which
/// figures draw them as one.
constexpr double told_apart = 0.25;

/// Adds a point at `x` to a curve: the stress ratio (o = 0) or the solid fraction (o = 1) in
/// `shown`, with its standard error.
void add_point(Curve& curve, double x, const Shown& shown, std::size_t o);

/// Text that names effects in the title or key of a figure: "lid-slip", "lid-slip and
/// torque-offset", "3 effects"; empty for none.
std::string names_of(const std::vector<const Effect*>& effects);

/// Whether all values are positive and the greatest is more than 10 times the least, so that a
/// logarithmic axis suits.
bool spans_decade(const std::vector<double>& values);

/// Text of an inertial number in a figure: "I = 0.003", or "I → 0" for the quasi-static limit 0.
std::string inertial_text(double inertial_number);

}  // namespace pendular
