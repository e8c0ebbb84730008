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

/// Reading with its prediction. Index 0 is the shear stress [Pa], 1 the solid fraction [1].
struct ReadingMisfit {
    Reading reading;
    Eigen::Vector2d predicted;
    Eigen::Matrix2d predicted_covariance;
    Eigen::Vector2d chi2;  ///< contributions to the total chi2, by observable; none is negative
    Eigen::Vector2d
        normalised;  ///< (measured - predicted) over the standard error of the difference [1]
};

/// Readings of one condition (replicates) taken together.
struct ConditionMisfit {
    Condition condition;
    std::vector<std::size_t> readings;  ///< indices into Comparison::readings
    double chi2 = 0;
    /// Mean of (measured - predicted) over its standard error, by observable [1].
    Eigen::Vector2d normalised = Eigen::Vector2d::Zero();
};

/// Readings of one file taken together.
struct FileMisfit {
    std::string file;
    std::size_t readings = 0;
    double chi2 = 0;
};

/// Direct measurement with the model's prediction.
struct DirectMisfit {
    DirectMeasurement measurement;
    double predicted = 0;  ///< predicted value [unit of the parameter]

    double normalised() const {
        return (measurement.value - predicted) / measurement.standard_error;
    }
};

/// Degrees of freedom behind the errors of readings, whose variances were estimated in groups:
///     1/nu = sum (n_g/n)^2/nu_g
/// Source: Satterthwaite, Biometrics Bull. 2 (1946) 110, for equal variances.
double freedom_behind(std::span<const Reading> readings);

/// Misfit of a set of readings: chi2 with its degrees of freedom.
struct Misfit {
    double chi2 = 0;  ///< with the scatter of replicates as it was estimated
    int dof = 0;
    double freedom = INFINITY;  ///< degrees of freedom behind the errors

    /// Probability of a chi2 at least this large if the model and all errors are right [1]; where
    /// the errors were estimated, by the F distribution of chi2/dof.
    double p() const;
};

/// Comparison of measurement and model.
struct Comparison {
    std::vector<ReadingMisfit> readings;
    std::vector<DirectMisfit> direct;
    /// Misfits by condition; their chi2 add up to the total without the direct measurements.
    std::vector<ConditionMisfit> by_condition;
    std::vector<FileMisfit> by_file;  ///< misfits by file; their chi2 add up to the same total
    std::array<double, 2>
        by_observable{};  ///< chi2 of shear stress and solid fraction; they add up too
    std::array<double, 2> rms_percent{};  ///< 100 sqrt(mean((predicted/measured - 1)^2))
    Misfit total;
    Misfit fitted;     ///< readings the parameters were fitted to, and direct measurements
    Misfit predicted;  ///< readings that were predicted, not fitted; both chi2 add up to the total
};

/// Compares every reading with its prediction.
///     chi2 = e' (Sigma_measurement + Sigma_simulation)^-1 e,  e = measured - predicted
/// split so that entry i contributes the square of its decorrelated misfit (ZCA-cor). `fitted` of
/// the readings, the first ones, were fitted with so many parameters.
Comparison compare(const std::vector<Reading>& readings, const Prediction& prediction,
                   int parameters, std::size_t fitted);

/// Compares all readings and direct measurements of a calibration with the model.
Comparison compare(const Calibration& calibration);

}  // namespace pendular
