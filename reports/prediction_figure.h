#pragma once

#include <string>
#include <vector>

#include "reports/figure.h"
#include "workflow/state_prediction.h"

namespace pendular {

/// Checks that a predicted curve has values of a quantity, which is an observable of the simulation
/// or a closure (analytical formula).
/// @param name name of the quantity, as in the JSON output of the program
/// @throws InputError if the curve has no values of the quantity; the message suggests the known
///         name with the most similar spelling
void check_drawable(const std::string& name, const PredictionCurve& curve);

/// Returns a figure of predictions along a curve of flow states, one panel for each quantity. The
/// emulator, which interpolates between simulations, predicts observables with their standard
/// errors. A closure (analytical formula) is computed from the predicted observables. Panels of
/// observables also show the simulations near the curve. These simulations agree within 5 % with
/// the curve in stiffness number and in all quantities that do not vary along the curve.
/// @param drawn names of the quantities, which `check_drawable` accepts
Figure prediction_figure(const PredictionCurve& curve, const Emulator& emulator,
                         const std::vector<std::string>& drawn);

/// Returns predictions along a curve of flow states as CSV, one row per state. The first columns
/// are friction coefficient, inertial number, reduced pressure and bridge volume. Reduced pressure
/// and bridge volume are empty for dry states. Then follows every predicted observable with its
/// standard error. For wet states, the last columns are the values of the closures (analytical
/// formulas).
std::string prediction_table(const PredictionCurve& curve);

}  // namespace pendular
