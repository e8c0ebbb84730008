#pragma once

#include <string>
#include <vector>

#include "reports/figure.h"
#include "workflow/state_prediction.h"

namespace pendular {

/// Checks that `name` is an observable, or a closure (analytical formula), that a predicted curve
/// has values of.
/// @throws InputError where it is not, naming the nearest name
void check_drawable(const std::string& name, const PredictionCurve& curve);

/// Figure with a panel for each of `drawn`, names that `check_drawable` accepts, along a curve of
/// flow states: observables as the emulator (which interpolates between simulation runs) predicts
/// them, with standard errors, and values of closures that follow from the predictions. Panels of
/// observables show the emulator's runs near the curve, whose other quantities and stiffness number
/// agree with it within 5 %.
Figure prediction_figure(const PredictionCurve& curve, const Emulator& emulator,
                         const std::vector<std::string>& drawn);

/// CSV of a predicted curve, one row per flow state: friction, inertial number, reduced pressure
/// and bridge volume (both empty: dry), then every predicted observable with its standard error
/// and, for wet states, the values of the closures.
std::string prediction_table(const PredictionCurve& curve);

}  // namespace pendular
