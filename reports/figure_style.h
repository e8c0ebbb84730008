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
                             "#606060",  ///< colour of key (legend) entries common to all series
    shape_colour = "#555555";            ///< of entries that explain shapes of symbols

// One grammar for all figures of a study: what is measured is a filled symbol with its error bar;
// the model is a line with a band of one standard error, or hollow symbols where no line passes the
// readings; colour, shape of the symbol and dash of the line say which series (liquid content,
// normal stress, file) both belong to.

/// Texts of a key for the kinds of data.
inline const std::string measured_text = "measured, ± 1 standard error",
                         model_text = "model, ± 1 standard error",
                         model_at_readings_text = "model at the readings";

/// Colour, shape and dash of one series.
struct SeriesLook {
    std::string colour;
    Shape shape = Shape::circle;
    std::string dash = "solid";
};
/// Series up to which each has an entry in the key; more share a scale of colours, so that no key
/// has more than eight entries.
constexpr std::size_t most_named_series = 4;
/// Returns the look of the series `k` of `count`. Up to `most_named_series`, shapes and dashes
/// differ; more have colours from dark to light.
SeriesLook look_of_series(std::size_t k, std::size_t count);
/// Look of dry readings beside wet ones.
inline const SeriesLook dry_look{"#7a7a7a", Shape::diamond, "(2,3)"};

/// Returns an empty curve of measured values in the look of a series.
Curve measured_points(const std::string& label, const SeriesLook& look);
/// Returns an empty curve of predictions of single readings in the look of a series.
Curve model_points(const std::string& label, const SeriesLook& look);
/// Returns an empty line of a model in the look of a series.
Curve model_line(const std::string& label, const SeriesLook& look);

/// Returns key entries that name series: one each, or a scale of colours for more than
/// `most_named_series`.
std::vector<Curve> series_entries(const std::vector<std::string>& names);
/// Returns a key entry that explains one kind of data for all series.
Curve kind_entry(const std::string& label, Curve::Style style, Filling filling = Filling::filled);

/// Factor on shifts and errors of a friction coefficient in figures [1].
inline constexpr double in_thousandths = 1e3;

/// Stress ratio [1] and solid fraction [1] of a reading or prediction, in this order, with their
/// standard errors, as figures draw them.
struct Shown {
    std::array<double, 2> value, error;
};
/// Returns the measured values.
Shown shown(const Reading& reading);

/// Returns the predicted values at the condition of one reading.
/// @param place index of the reading in `predicted`
/// @param normal_stress of the reading [Pa], by which the shear stress is divided
Shown shown(const Prediction& predicted, Eigen::Index place, double normal_stress);

/// Returns the means with the weights 1/(standard error)^2. Their standard errors hold if the
/// errors of the averaged values are independent.
Shown mean_of(const std::vector<Shown>& all);

/// Means of the measured and of the predicted values over some readings.
struct MeasuredAndModel {
    Shown measured, model;
};
/// Returns the means with the weights 1/(standard error of the measured value)^2. The standard
/// errors contain what readings share.
/// @param places indices of the readings in `calibration.readings`
/// @param covariance covariance of the measured values of all readings
MeasuredAndModel means_of(const std::vector<std::size_t>& places, const Calibration& calibration,
                          const Eigen::MatrixXd& covariance);

/// Whether one point, the mean prediction, may stand for the predictions of all these readings:
/// each differs from the mean by at most `same_point` standard errors of the measured value.
/// @param places indices of the readings in `calibration.readings`
bool mean_suffices(const std::vector<std::size_t>& places, const Calibration& calibration);

/// Largest difference between the prediction of a reading and the mean or curve drawn in its place,
/// over the standard error of the measured value [1].
constexpr double same_point = 0.25;

/// Adds a point with an error bar of one standard error.
/// @param o quantity drawn as y: 0 for the stress ratio, 1 for the solid fraction
void add_point(Curve& curve, double x, const Shown& shown, std::size_t o);

/// Returns names of effects for a title or key: "lid-slip", "lid-slip and torque-offset", "3
/// effects"; empty for none.
std::string names_of(const std::vector<const Effect*>& effects);

/// Whether all values are positive and the greatest is more than 10 times the least.
bool spans_decade(const std::vector<double>& values);

/// Returns "I = 0.003", with two significant digits, or "I → 0" for the quasi-static limit 0.
std::string inertial_text(double inertial_number);

}  // namespace pendular
