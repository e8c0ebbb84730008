#pragma once

#include <vector>

#include "calib/fit/calibration.h"
#include "calib/fit/fit.h"
#include "calib/model/predictor.h"

namespace pendular {

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
    /// Readings in the order of `Calibration::readings`.
    std::vector<Reading> readings;
    /// Whether a reading was changed, for each reading.
    std::vector<bool> moved;
    LineValues measured;  ///< values of `readings`
    /// Predictions of `readings`, with the errors of the fitted parameters where any reading was
    /// moved.
    Prediction predicted;

    /// Predictions as values of lines, with the weights of the readings.
    LineValues simulated() const {
        return {"simulated", predicted.value, predicted.covariance, measured.weighting};
    }
};

/// Brings all readings to the inertial number `Calibration::cohesion` states. If it
/// states none, the common inertial number is that of the wet readings if they agree within 20 %,
/// and 0 otherwise. Readings that agree with it within 20 % are not changed, unless the model has
/// effects of the instrument.
/// @param model model of the calibration
ReadingsAtOneRate at_one_inertial_number(const Predictor& model, const Calibration& calibration);

}  // namespace pendular
