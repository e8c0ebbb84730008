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

/// Reading with the model's prediction. Index 0 is the shear stress [Pa], 1 the solid fraction [1].
struct ReadingMisfit {
    Reading reading;
    Eigen::Vector2d predicted;             ///< (shear stress [Pa], solid fraction [1])
    Eigen::Matrix2d predicted_covariance;  ///< covariance of the errors of `predicted`
    Eigen::Vector2d chi2;  ///< part of chi2 of all readings from each observable, never negative
    /// (measured - predicted) of each observable, over the standard error of this difference from
    /// errors of measurement and prediction [1].
    Eigen::Vector2d normalised;
};

/// Misfit of all readings of one condition (replicates) together.
struct ConditionMisfit {
    Condition condition;
    std::vector<std::size_t> readings;  ///< indices into Comparison::readings
    double chi2 = 0;                    ///< sum of the readings' contributions to chi2
    /// Mean of (measured - predicted) over the condition's readings, divided by the standard error
    /// of that mean, for (shear stress, solid fraction) [1].
    Eigen::Vector2d normalised = Eigen::Vector2d::Zero();
};

/// Misfit of all readings of one file together.
struct FileMisfit {
    std::string file;
    std::size_t readings = 0;  ///< number of readings of the file
    double chi2 = 0;           ///< sum of the readings' contributions to chi2
};

/// Direct measurement of a parameter of the model, with the value that the fitted model has.
struct DirectMisfit {
    DirectMeasurement measurement;
    /// Value of the parameter in the model [its unit]; in a model without the effect, the value at
    /// which the effect vanishes.
    double predicted = 0;

    /// (measured - predicted) value of the parameter over the standard error of the measurement
    /// [1].
    double normalised() const {
        return (measurement.value - predicted) / measurement.standard_error;
    }
};

/// Effective degrees of freedom nu with which the errors of n measured values were estimated;
/// infinite where all errors are known:
///     1/nu = sum (n_g/n)^2/nu_g,
/// where n_g of the n measured values share one estimate of the variance, which has nu_g degrees of
/// freedom.
/// Source: Satterthwaite, Biometrics Bull. 2 (1946) 110, for equal variances.
double freedom_behind(std::span<const Reading> readings);

/// Misfit of a set of readings: chi2 with its degrees of freedom.
struct Misfit {
    /// chi2, with errors as estimated from the scatter of replicates, not widened where there are
    /// few of them.
    double chi2 = 0;
    int dof = 0;  ///< degrees of freedom of `chi2`
    /// Degrees of freedom with which the errors of the readings were estimated; infinite: the
    /// errors are known.
    double freedom = INFINITY;

    /// p value: probability of a chi2 at least this large if model and errors are right [1]; 1
    /// without degrees of freedom. It is given by the chi2 distribution or, where the errors are
    /// estimated, by the F distribution of chi2/dof.
    double p() const;
};

/// Comparison of a study's readings and direct measurements with the predictions of its model.
struct Comparison {
    std::vector<ReadingMisfit> readings;  ///< all readings with their predictions
    std::vector<DirectMisfit> direct;     ///< direct measurements of parameters
    /// Misfit of the readings of each condition; the values of chi2 add up to chi2 of all readings.
    std::vector<ConditionMisfit> by_condition;
    /// Misfit of the readings of each file; the values of chi2 add up to chi2 of all readings.
    std::vector<FileMisfit> by_file;
    /// Parts of chi2 from (shear stress, solid fraction) of all readings; their sum is chi2 of all
    /// readings.
    std::array<double, 2> by_observable{};
    /// RMS errors of the predicted (shear stress, solid fraction) over all readings [%]; see the
    /// function `rms_percent`.
    std::array<double, 2> rms_percent{};
    Misfit total;      ///< misfit of all readings and direct measurements
    Misfit fitted;     ///< misfit of the fitted readings and the direct measurements
    Misfit predicted;  ///< misfit of the readings that were only predicted, not fitted
};

/// RMS errors of predicted (shear stress, solid fraction) over all readings [%]:
///     100 sqrt(mean((predicted/measured - 1)^2)).
/// @param values predicted shear stress [Pa] and solid fraction [1] of each reading, in turn;
///        further entries are ignored
std::array<double, 2> rms_percent(const std::vector<Reading>& readings,
                                  const Eigen::VectorXd& values);

/// Compares every reading with its prediction:
///     chi2 = e' (Sigma_measurement + Sigma_simulation)^-1 e,  e = measured - predicted,
/// split so that entry i contributes the square of its decorrelated misfit (ZCA-cor).
/// @param parameters number of fitted parameters
/// @param fitted number of fitted readings, which come first; the others were only predicted
Comparison compare(const std::vector<Reading>& readings, const Prediction& prediction,
                   int parameters, std::size_t fitted);

/// Compares all readings and direct measurements of a calibration with the model.
Comparison compare(const Calibration& calibration);

}  // namespace pendular
