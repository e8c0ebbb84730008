#pragma once

#include <vector>

#include "calib/fit/calibration.h"
#include "calib/model/predictor.h"

namespace pendular {

/// Predicts the shear stress [Pa] and solid fraction [1] at `conditions` of which a calibration did
/// not fit readings, at its fitted parameters. The covariance of the prediction is
///     S + J C J' - X - X',  X = J K S_f,
/// with the covariance S of the model's errors, the derivatives J of the predictions with respect
/// to the parameters, and the covariance C of the fitted parameters. K contains the derivatives of
/// the fitted parameters with respect to the measured values. S_f is the covariance of the model's
/// errors at the fitted readings (rows) with those at `conditions` (columns). X corrects for errors
/// that the fit has already compensated.
Prediction predict_unseen(const Predictor& model, const Calibration& calibration,
                          const std::vector<Condition>& conditions);

/// Prediction as by `predict_unseen`, and what its errors have in common with those of the fitted
/// readings, through the parameters.
struct UnseenAndFitted {
    Prediction unseen;
    /// Covariance J K S_y between the errors of the prediction (rows) and of the measured values of
    /// the fitted readings (columns), whose covariance is S_y.
    Eigen::MatrixXd with_fitted;
};
UnseenAndFitted predict_with_fitted(const Predictor& model, const Calibration& calibration,
                                    const std::vector<Condition>& conditions);

/// Predicts the shear stress [Pa] and solid fraction [1] of each reading of a calibration. For
/// readings that were not fitted, the covariance includes the uncertainty of the fitted parameters
/// (`predict_unseen`). Their covariance with fitted readings is set to 0.
Prediction predict_readings(const Predictor& model, const Calibration& calibration);

}  // namespace pendular
