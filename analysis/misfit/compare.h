#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <string>
#include <vector>

#include "calib/fit/calibration.h"
#include "data/reading.h"

namespace pendular {

/// Reading with its prediction and misfit. Pairs of numbers are for shear stress and solid
/// fraction.
struct ReadingMisfit {
    Reading reading;
    Eigen::Vector2d predicted;             ///< [Pa, 1]
    Eigen::Matrix2d predicted_covariance;  ///< covariance of the errors of `predicted`
    Eigen::Vector2d chi2;                  ///< contributions to chi2 [1], not negative (`compare`)
    /// Normalised residuals [1]: measured minus predicted value over the standard error of this
    /// difference, which includes errors of measurement and prediction.
    Eigen::Vector2d normalised;
};

/// Misfit of all readings at one condition together.
struct ConditionMisfit {
    Condition condition;
    std::vector<std::size_t> readings;  ///< indices into Comparison::readings
    double chi2 = 0;                    ///< contributions of the readings to chi2 [1]
    /// Normalised mean residuals [1]: mean of measured minus predicted values over its standard
    /// error.
    Eigen::Vector2d normalised = Eigen::Vector2d::Zero();
};

/// Misfit of all readings of one file together.
struct FileMisfit {
    std::string file;
    std::size_t readings = 0;  ///< number of readings
    double chi2 = 0;           ///< contributions of the readings to chi2 [1]
};

/// Direct measurement with the value of its parameter in the fitted model.
struct DirectMisfit {
    DirectMeasurement measurement;
    /// Value in the model [unit of the parameter]; `DirectMeasurement::neutral`, such as 1 for a
    /// torque gain, if the model lacks the effect.
    double predicted = 0;
    double predicted_error = 0;  ///< standard uncertainty that the study states of `predicted`

    double normalised() const {
        return (measurement.value - predicted) /
               std::hypot(measurement.standard_error, predicted_error);
    }
};

/// Returns the effective number nu of degrees of freedom [1] with which the errors of the readings
/// were estimated; infinite if all errors are known:
///     1/nu = sum_g (n_g/n)^2/nu_g.
/// The estimate g of the error variance has nu_g degrees of freedom and applies to n_g of the n
/// measured values (two for each reading).
/// Source: Satterthwaite, Biometrics Bull. 2 (1946) 110, for equal variances.
double freedom_behind(std::span<const Reading> readings);

/// p value [1] below which a misfit, an effect or a trend counts as significant: the usual 5 %.
inline constexpr double significant_p = 0.05;

/// chi2 of a set of readings with its degrees of freedom.
struct Misfit {
    /// chi2 [1], with errors that were estimated from replicates treated as exactly known.
    double chi2 = 0;
    int dof = 0;                ///< measured values minus parameters fitted to them
    double freedom = INFINITY;  ///< of the readings' errors [1] (`freedom_behind`)

    /// Returns the p value [1] of chi2 or, if errors are estimated, of chi2/dof by the F
    /// distribution; 1 without degrees of freedom.
    double p() const;
};

/// Comparison of readings and direct measurements with the predictions of a study's model.
struct Comparison {
    std::vector<ReadingMisfit> readings;
    std::vector<DirectMisfit> direct;
    std::vector<ConditionMisfit> by_condition;  ///< their chi2 add up to that of all readings
    std::vector<FileMisfit> by_file;            ///< their chi2 add up to that of all readings
    std::array<double, 2> by_observable{};      ///< contributions to chi2 [1]
    std::array<double, 2> rms_percent{};        ///< relative errors (`rms_percent`) [%]
    Misfit total;                               ///< all readings and direct measurements
    Misfit fitted;                              ///< fitted readings and direct measurements
    Misfit predicted;                           ///< readings that were predicted, not fitted
};

/// Returns the relative RMS errors [%] of predicted shear stress and solid fraction:
/// 100 sqrt(mean((predicted/measured - 1)^2)).
/// @param values predicted shear stress [Pa] and solid fraction [1] of each reading in turn;
///        further entries are ignored
std::array<double, 2> rms_percent(const std::vector<Reading>& readings,
                                  const Eigen::VectorXd& values);

/// Compares readings with their predictions, and divides chi2 among readings, conditions, files and
/// observables:
///     chi2 = e' (Sigma_measurement + Sigma_simulation)^-1 e,  e = measured - predicted.
/// The contribution of a measured value is the square of its entry of the residuals after ZCA-cor
/// whitening, which makes them uncorrelated with as little change as possible.
/// @param parameters number of fitted parameters
/// @param fitted number of fitted readings, which come first in `readings`
/// Source: Kessy, Lewin and Strimmer, Am. Stat. 72 (2018) 309.
Comparison compare(const std::vector<Reading>& readings, const Prediction& prediction,
                   int parameters, std::size_t fitted);

/// Compares readings and direct measurements of a calibration with its predictions. Constant
/// cohesions that were fitted to the wet readings beforehand reduce the degrees of freedom.
Comparison compare(const Calibration& calibration);

}  // namespace pendular
