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

/// Reading with the prediction of a study's model and the misfit. In each pair of numbers, the
/// first is for the shear stress and the second for the solid fraction.
struct ReadingMisfit {
    Reading reading;
    /// Shear stress [Pa] and solid fraction [1] that the model predicts for the reading.
    Eigen::Vector2d predicted;
    /// Covariance matrix of the errors of `predicted`. The first row and column are for the shear
    /// stress [Pa], the second for the solid fraction [1].
    Eigen::Matrix2d predicted_covariance;
    /// Contributions [1] of the reading's shear stress (first) and solid fraction (second) to the
    /// chi2 of all readings. No contribution is negative.
    Eigen::Vector2d chi2;
    /// Normalised residuals [1] of the reading's shear stress (first) and solid fraction (second):
    /// measured minus predicted value, divided by the standard error of this difference. The
    /// standard error includes errors of measurement and prediction.
    Eigen::Vector2d normalised;
};

/// Misfit of a model to all readings at one condition (replicates) together.
struct ConditionMisfit {
    Condition condition;
    /// Readings at the condition, as indices into Comparison::readings.
    std::vector<std::size_t> readings;
    double chi2 = 0;  ///< sum of the contributions of the condition's readings to chi2 [1]
    /// Normalised mean residuals [1] of the shear stress (first) and of the solid fraction
    /// (second): measured minus predicted value, averaged over the readings at the condition and
    /// divided by the standard error of this mean. The standard error includes errors of
    /// measurement and prediction.
    Eigen::Vector2d normalised = Eigen::Vector2d::Zero();
};

/// Misfit of a model to all readings of one file together.
struct FileMisfit {
    std::string file;
    /// Number of readings in the file.
    std::size_t readings = 0;
    double chi2 = 0;  ///< sum of the contributions of the file's readings to chi2 [1]
};

/// Direct measurement of an effect's parameter (without shearing grains), with the value of the
/// parameter in the fitted model.
struct DirectMisfit {
    DirectMeasurement measurement;
    /// Value of the parameter in the fitted model [unit of the parameter]. If the model lacks the
    /// effect, the value is `DirectMeasurement::neutral`, such as 1 for a torque gain.
    double predicted = 0;

    /// Returns the normalised residual [1]: the measured minus the predicted value of the
    /// parameter, divided by the standard error of the measurement.
    double normalised() const {
        return (measurement.value - predicted) / measurement.standard_error;
    }
};

/// Returns the effective number nu of degrees of freedom [1] with which the errors of the readings
/// were estimated:
///     1/nu = sum_g (n_g/n)^2/nu_g.
/// The estimate g of the error variance has nu_g degrees of freedom and applies to n_g of the n
/// measured values (two for each reading). The number nu is infinite if all errors are known.
/// Source: Satterthwaite, Biometrics Bull. 2 (1946) 110, for equal variances.
double freedom_behind(std::span<const Reading> readings);

/// Misfit of a model to a set of readings: chi2 with the degrees of freedom.
struct Misfit {
    /// chi2 of the readings [1]. Errors that were estimated from the scatter of replicates
    /// (readings at the same condition) are treated as exactly known, even if the replicates are
    /// few.
    double chi2 = 0;
    /// Degrees of freedom of `chi2`: number of measured values minus number of parameters fitted to
    /// these values.
    int dof = 0;
    /// Effective number of degrees of freedom [1] with which the errors of the readings were
    /// estimated (`freedom_behind`). The number is infinite if the errors are known.
    double freedom = INFINITY;

    /// Returns the p value [1]: probability of a chi2 at least as large as `chi2` if the model and
    /// the errors are right. The p value is 1 if there are no degrees of freedom. The p value
    /// follows from the chi2 distribution or, if errors are estimated, from the F distribution of
    /// chi2/dof.
    double p() const;
};

/// Comparison of a study's readings, and of its direct measurements of effects' parameters, with
/// the predictions of the study's model.
struct Comparison {
    std::vector<ReadingMisfit> readings;  ///< all readings with their predictions and misfits
    /// Direct measurements of effects' parameters (without shearing grains), each with the value of
    /// the parameter in the fitted model.
    std::vector<DirectMisfit> direct;
    /// Misfit of the readings at each condition. The contributions of all conditions to chi2 add up
    /// to the chi2 of all readings.
    std::vector<ConditionMisfit> by_condition;
    /// Misfit of the readings of each file. The contributions of all files to chi2 add up to the
    /// chi2 of all readings.
    std::vector<FileMisfit> by_file;
    /// Contributions [1] of all shear stresses (first) and of all solid fractions (second) to the
    /// chi2 of all readings. The sum of both contributions is the chi2 of all readings.
    std::array<double, 2> by_observable{};
    /// Relative RMS errors [%] of the predicted shear stress (first) and solid fraction (second)
    /// for all readings: 100 sqrt(mean((predicted/measured - 1)^2)), with the mean over the
    /// readings.
    std::array<double, 2> rms_percent{};
    Misfit total;      ///< misfit of all readings and direct measurements
    Misfit fitted;     ///< misfit of the fitted readings and the direct measurements
    Misfit predicted;  ///< misfit of the readings that were only predicted, not fitted
};

/// Returns the relative RMS errors [%] of the predicted shear stress (first) and solid fraction
/// (second) for all readings:
///     100 sqrt(mean((predicted/measured - 1)^2)).
/// @param values predicted shear stress [Pa] and solid fraction [1] of each reading, in turn;
///        further entries are ignored
std::array<double, 2> rms_percent(const std::vector<Reading>& readings,
                                  const Eigen::VectorXd& values);

/// Compares readings with their predictions, and divides chi2 among readings, conditions, files and
/// observables:
///     chi2 = e' (Sigma_measurement + Sigma_simulation)^-1 e,  e = measured - predicted,
/// with the covariances Sigma of the errors of measurement and simulation. ZCA-cor whitening
/// converts the normalised residuals, with as little change as possible, to uncorrelated residuals.
/// The contribution of a measured value to chi2 is the square of its uncorrelated residual.
/// @param prediction prediction of all readings, with the covariance of its errors
/// @param parameters number of fitted parameters
/// @param fitted number of fitted readings, which come first in `readings`; all other readings were
///        only predicted
/// Source: Kessy, Lewin and Strimmer, Am. Stat. 72 (2018) 309.
Comparison compare(const std::vector<Reading>& readings, const Prediction& prediction,
                   int parameters, std::size_t fitted);

/// Compares all readings and direct measurements of a calibration with the predictions of the
/// calibration's model. The number of constant cohesions that were fitted to the wet readings
/// beforehand is subtracted from the degrees of freedom.
Comparison compare(const Calibration& calibration);

}  // namespace pendular
