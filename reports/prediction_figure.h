#pragma once

#include <string>
#include <vector>

#include "reports/figure.h"
#include "workflow/state_prediction.h"

namespace pendular {

/// Checks that a predicted curve has values of a quantity: of an observable, or of a closure
/// (analytical formula).
/// @param name name of the quantity, as in JSON
/// @throws InputError where the curve has no such quantity; the message names the nearest name
void check_drawable(const std::string& name, const PredictionCurve& curve);

/// Figure of predictions along a curve of flow states, one panel for each quantity: observables as
/// the emulator (which interpolates between simulation runs) predicts them, with standard errors,
/// and closures (analytical formulas) computed from the predictions. Panels of observables also
/// show the emulator's runs near the curve, whose other quantities and stiffness number agree with
/// those of the curve within 5 %.
/// @param drawn names of the quantities, which `check_drawable` accepts
Figure prediction_figure(const PredictionCurve& curve, const Emulator& emulator,
                         const std::vector<std::string>& drawn);

/// Returns predictions along a curve of flow states as CSV, one row per state: friction, inertial
/// number, reduced pressure and bridge volume (both empty for dry states), then every predicted
/// observable with its standard error and, for wet states, the values of the closures (analytical
/// formulas).
std::string prediction_table(const PredictionCurve& curve);

}  // namespace pendular
