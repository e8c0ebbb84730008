#pragma once

#include <vector>

#include "calib/fit/calibration.h"
#include "calib/model/predictor.h"

namespace pendular {

/// Predicts the shear stress [Pa] and solid fraction [1] at each of `conditions` (normal stress,
/// inertial number and liquid content) in turn, at the fitted parameters of a calibration that did
/// not fit readings at these conditions. The covariance of the prediction is
///     S + J C J' - X - X',  X = J K S_f,
/// with the covariance S of the model's errors, the derivatives J of the predictions with respect
/// to the parameters, and the covariance C of the fitted parameters. K contains the derivatives of
/// the fitted parameters with respect to the measured values. S_f is the covariance of the model's
/// errors at the fitted readings (rows) with the model's errors at `conditions` (columns). X
/// corrects for errors that the fit has already compensated.
Prediction predict_unseen(const Predictor& model, const Calibration& calibration,
                          const std::vector<Condition>& conditions);

/// Prediction as by `predict_unseen`, and what its errors have in common with those of the fitted
/// readings, through the parameters.
struct UnseenAndFitted {
    Prediction unseen;
    /// Covariance J K S between the errors of the prediction (rows) and of the measured values of
    /// the fitted readings (columns), whose covariance is S.
    Eigen::MatrixXd with_fitted;
};
UnseenAndFitted predict_with_fitted(const Predictor& model, const Calibration& calibration,
                                    const std::vector<Condition>& conditions);

/// Predicts, at the fitted parameters of a calibration, the shear stress [Pa] and solid fraction
/// [1] of each reading of the study in turn, whether fitted or not. For readings that were not
/// fitted, the covariance includes the uncertainty of the fitted parameters (`predict_unseen`). The
/// covariance between fitted readings and readings that were not fitted is set to 0.
Prediction predict_readings(const Predictor& model, const Calibration& calibration);

}  // namespace pendular
