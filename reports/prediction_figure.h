#pragma once

#include <string>
#include <vector>

#include "reports/figure.h"
#include "workflow/state_prediction.h"

namespace pendular {

/// Checks that a quantity, an observable of the simulation or a closure (analytical formula), was
/// predicted along the curve.
/// @param name as in the JSON output of the program
/// @throws InputError if not; the message suggests the known name with the most similar spelling
void check_drawable(const std::string& name, const PredictionCurve& curve);

/// Returns a panel for each quantity along the curve. The emulator predicts observables with
/// standard errors; closures are computed from them. Panels of observables also show the
/// simulations near the curve: those that agree with it within 5 % in stiffness number and in all
/// quantities that do not vary along it.
/// @param drawn names that `check_drawable` accepts
Figure prediction_figure(const PredictionCurve& curve, const Emulator& emulator,
                         const std::vector<std::string>& drawn);

/// Returns the predictions as CSV, one row per state: friction, inertial number, P* and V0/a^3
/// (both empty for dry states), each observable with its standard error and, for wet states, the
/// closures.
std::string prediction_table(const PredictionCurve& curve);

}  // namespace pendular
