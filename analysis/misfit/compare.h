#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "calib/fit/calibration.h"
#include "data/reading.h"

namespace pendular {

/// Reading with the model's prediction. All pairs are in the order (shear stress, solid fraction).
struct ReadingMisfit {
    Reading reading;
    /// Shear stress [Pa] and solid fraction [1] that the model predicts for the reading.
    Eigen::Vector2d predicted;
    /// Covariance of the errors of the predicted shear stress [Pa] and solid fraction [1].
    Eigen::Matrix2d predicted_covariance;
    /// Part of the chi2 of all readings that each observable of this reading contributes [1], never
    /// negative.
    Eigen::Vector2d chi2;
    /// Normalised residual of each observable [1]: (measured - predicted), divided by the standard
    /// error of this difference from errors of measurement and prediction.
    Eigen::Vector2d normalised;
};

/// Misfit of the readings of one condition (replicates) together.
struct ConditionMisfit {
    Condition condition;
    /// Readings of the condition, as indices into Comparison::readings.
    std::vector<std::size_t> readings;
    double chi2 = 0;  ///< sum of the readings' contributions to chi2
    /// Normalised mean residual of (shear stress, solid fraction) [1]: mean of (measured -
    /// predicted) over the condition's readings, divided by the standard error of that mean.
    Eigen::Vector2d normalised = Eigen::Vector2d::Zero();
};

/// Misfit of all readings of one file together.
struct FileMisfit {
    std::string file;
    /// Number of readings in the file.
    std::size_t readings = 0;
    double chi2 = 0;  ///< sum of the readings' contributions to chi2
};

/// Direct measurement of an effect's parameter, beside the value of the parameter in the fitted
/// model.
struct DirectMisfit {
    DirectMeasurement measurement;
    /// Value of the parameter in the fitted model [its unit]; in a model without the effect, the
    /// value at which the effect vanishes.
    double predicted = 0;

    /// Normalised residual [1]: (measured - predicted) value of the parameter, divided by the
    /// standard error of the measurement.
    double normalised() const {
        return (measurement.value - predicted) / measurement.standard_error;
    }
};

/// Effective number of degrees of freedom nu [1] with which the errors of n measured values were
/// estimated; infinite if all errors are known:
///     1/nu = sum_g (n_g/n)^2/nu_g,
/// where n_g of the n values (two for each reading) share the estimate g of the variance, which has
/// nu_g degrees of freedom.
/// Source: Satterthwaite, Biometrics Bull. 2 (1946) 110, for equal variances.
double freedom_behind(std::span<const Reading> readings);

/// Misfit of a set of readings: chi2 with its degrees of freedom.
struct Misfit {
    /// chi2 of the readings. Their errors are estimated from the scatter of replicates and not
    /// widened for few replicates.
    double chi2 = 0;
    /// Degrees of freedom of the misfit `chi2`.
    int dof = 0;
    /// Effective degrees of freedom with which the errors of the readings were estimated
    /// (`freedom_behind`); infinite: the errors are known.
    double freedom = INFINITY;

    /// p value [1]: probability of a chi2 at least this large if model and errors are right; 1
    /// without degrees of freedom. It follows from the chi2 distribution or, if errors are
    /// estimated, from the F distribution of chi2/dof.
    double p() const;
};

/// Comparison of a study's readings and direct measurements with the predictions of its model.
struct Comparison {
    std::vector<ReadingMisfit> readings;  ///< all readings with their predictions
    /// Direct measurements of effects' parameters, each beside the value of the parameter in the
    /// fitted model.
    std::vector<DirectMisfit> direct;
    /// Misfit of the readings of each condition; their chi2 add up to that of all readings.
    std::vector<ConditionMisfit> by_condition;
    /// Misfit of the readings of each file; their chi2 add up to that of all readings.
    std::vector<FileMisfit> by_file;
    /// Parts of the chi2 of all readings that come from (shear stress, solid fraction); the parts
    /// add up to this chi2.
    std::array<double, 2> by_observable{};
    /// RMS errors of the predicted (shear stress, solid fraction) over all readings [%]: 100
    /// sqrt(mean((predicted/measured - 1)^2)).
    std::array<double, 2> rms_percent{};
    Misfit total;      ///< misfit of all readings and direct measurements
    Misfit fitted;     ///< misfit of the fitted readings and the direct measurements
    Misfit predicted;  ///< misfit of the readings that were only predicted, not fitted
};

/// Returns the RMS errors of the predicted (shear stress, solid fraction) over all readings [%]:
///     100 sqrt(mean((predicted/measured - 1)^2)).
/// @param values predicted shear stress [Pa] and solid fraction [1] of each reading, in turn;
///        further entries are ignored
std::array<double, 2> rms_percent(const std::vector<Reading>& readings,
                                  const Eigen::VectorXd& values);

/// Compares readings with their predictions:
///     chi2 = e' (Sigma_measurement + Sigma_simulation)^-1 e,  e = measured - predicted,
/// with the covariances Sigma of measurement and simulation. chi2 is split among the measured
/// values by ZCA-cor whitening, which makes the misfits e uncorrelated while changing them as
/// little as possible: each value contributes the square of its uncorrelated misfit.
/// @param prediction prediction of all readings, with its covariance
/// @param parameters number of fitted parameters
/// @param fitted number of fitted readings, which come first; the others were only predicted
/// Source: Kessy, Lewin and Strimmer, Am. Stat. 72 (2018) 309.
Comparison compare(const std::vector<Reading>& readings, const Prediction& prediction,
                   int parameters, std::size_t fitted);

/// Compares all readings and direct measurements of a calibration with the predictions of its
/// model. Constant cohesions that the model fitted beforehand are subtracted from the degrees of
/// freedom.
Comparison compare(const Calibration& calibration);

}  // namespace pendular
