#pragma once

#include <string>
#include <vector>

#include "reports/figure.h"
#include "workflow/state_prediction.h"

namespace pendular {

/// Checks that a quantity was predicted for the flow states along a curve. The quantity is an
/// observable of the simulation (such as the stress ratio) or a closure (analytical formula).
/// @param name name of the quantity, as in the JSON output of the program
/// @throws InputError if the curve has no values of the quantity; the message suggests the known
///         name with the most similar spelling
void check_drawable(const std::string& name, const PredictionCurve& curve);

/// Returns a figure of predictions for flow states along a curve, on which one quantity varies
/// (such as the inertial number), with one panel for each predicted quantity. The emulator, which
/// interpolates between simulations, predicts observables with their standard errors. A closure
/// (analytical formula) is computed from the predicted observables. Panels of observables also show
/// the simulations near the curve. These simulations agree within 5 % with the curve in stiffness
/// number and in all quantities that do not vary along the curve.
/// @param drawn names of the predicted quantities to draw, which `check_drawable` accepts
Figure prediction_figure(const PredictionCurve& curve, const Emulator& emulator,
                         const std::vector<std::string>& drawn);

/// Returns predictions for flow states along a curve as CSV, one row per state. The first columns
/// are friction coefficient, inertial number, reduced pressure and bridge volume divided by the
/// cube of the grain diameter [1]. Reduced pressure and bridge volume are empty for dry states.
/// Then follows every predicted observable with its standard error. For wet states, the last
/// columns are the values of the closures (analytical formulas).
std::string prediction_table(const PredictionCurve& curve);

}  // namespace pendular
