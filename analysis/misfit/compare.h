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
    Eigen::Vector2d predicted;
    Eigen::Matrix2d predicted_covariance;
    Eigen::Vector2d chi2;  ///< contribution of each observable to the total chi2, never negative
    /// (measured - predicted) over the standard error of the difference [1].
    Eigen::Vector2d normalised;
};

/// Misfit of all readings of one condition (replicates) together.
struct ConditionMisfit {
    Condition condition;
    std::vector<std::size_t> readings;  ///< indices into Comparison::readings
    double chi2 = 0;                    ///< sum of the readings' contributions to chi2
    /// Mean of (measured - predicted) over the standard error of that mean, for (shear stress,
    /// solid fraction) [1].
    Eigen::Vector2d normalised = Eigen::Vector2d::Zero();
};

/// Misfit of all readings of one file together.
struct FileMisfit {
    std::string file;
    std::size_t readings = 0;  ///< number of readings
    double chi2 = 0;           ///< sum of the readings' contributions to chi2
};

/// Direct measurement with the model's prediction.
struct DirectMisfit {
    DirectMeasurement measurement;
    double predicted = 0;  ///< predicted value [unit of the parameter]

    /// (measured - predicted) over the standard error of the measurement [1].
    double normalised() const {
        return (measurement.value - predicted) / measurement.standard_error;
    }
};

/// Effective degrees of freedom nu of the estimated errors of readings; infinite where all errors
/// are known:
///     1/nu = sum (n_g/n)^2/nu_g,
/// where n_g of the n measured values share one estimate of the variance, which has nu_g degrees of
/// freedom.
/// Source: Satterthwaite, Biometrics Bull. 2 (1946) 110, for equal variances.
double freedom_behind(std::span<const Reading> readings);

/// Misfit of a set of readings: chi2 with its degrees of freedom.
struct Misfit {
    double chi2 = 0;  ///< chi2 with the scatter as replicates give it, not widened for their number
    int dof = 0;      ///< degrees of freedom of `chi2`
    /// Degrees of freedom with which the errors were estimated; infinite: the errors are known.
    double freedom = INFINITY;

    /// Probability of a chi2 at least this large if model and errors are right [1]: by the chi2
    /// distribution or, where the errors are estimated, by the F distribution of chi2/dof.
    double p() const;
};

/// Comparison of measurement and model.
struct Comparison {
    std::vector<ReadingMisfit> readings;
    std::vector<DirectMisfit> direct;
    /// Misfit of each condition; the chi2 add up to chi2 of all readings.
    std::vector<ConditionMisfit> by_condition;
    /// Misfit of each file; the chi2 add up to chi2 of all readings.
    std::vector<FileMisfit> by_file;
    /// chi2 of (shear stress, solid fraction); both add up to chi2 of all readings.
    std::array<double, 2> by_observable{};
    /// RMS errors of (shear stress, solid fraction) [%]:
    /// 100 sqrt(mean((predicted/measured - 1)^2)).
    std::array<double, 2> rms_percent{};
    Misfit total;      ///< misfit of all readings and direct measurements
    Misfit fitted;     ///< misfit of the fitted readings and the direct measurements
    Misfit predicted;  ///< misfit of the readings that were only predicted, not fitted
};

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
