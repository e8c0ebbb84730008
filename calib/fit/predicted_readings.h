#pragma once

#include <vector>

#include "calib/fit/calibration.h"
#include "calib/fit/fit.h"
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
/// readings that were not fitted, the covariance includes the uncertainty of the fitted parameters,
/// but not `Fit::inexactness`, as that of the fitted ones. Their covariance with these is set to 0.
Prediction predict_readings(const Predictor& model, const Calibration& calibration);

/// Readings of steady shear as an ideal instrument would show them at one inertial number.
///
/// At a constant speed of the lid, every normal stress has an inertial number of its own, so that
/// no two readings of a Mohr-Coulomb line have the same. The model knows how stress ratio and solid
/// fraction depend on I: a reading y at condition x becomes
///     y0 = y - (f(x) - f(x0)),    x0: the condition x, with the common inertial number and an
///                                     ideal instrument.
/// An offset of the torque or the weight of the beads would otherwise be taken for cohesion.
/// Only the difference of two predictions enters, so that a misfit of the model stays in y0. The
/// covariance of y0 contains the errors of the difference: those of the simulations, and those of
/// the fitted parameters, which all readings share.
struct ReadingsAtOneRate {
    double inertial_number = 0;  ///< the common inertial number [1]; 0: quasi-static limit
    /// Whether the readings were freed of what effects of the instrument add.
    bool ideal_instrument = false;
    std::vector<Reading> readings;  ///< in the order of `Calibration::readings`
    std::vector<bool> moved;        ///< whether each reading was changed
    LineValues measured;            ///< values of `readings`
    /// Predictions of `readings`, with the errors of the parameters if any reading was moved.
    Prediction predicted;

    /// Returns the predictions as values of lines, with the weights of the readings.
    LineValues simulated() const {
        return {"simulated", predicted.value, predicted.covariance, measured.weighting};
    }
};

/// Returns all readings at the inertial number that `Calibration::cohesion` states or, if it states
/// none, at that of the wet readings if they agree within 20 %, and else at 0. Readings that agree
/// with it within 20 % are not changed, unless the model has effects of the instrument.
/// @param model model of the calibration
ReadingsAtOneRate at_one_inertial_number(const Predictor& model, const Calibration& calibration);

}  // namespace pendular
