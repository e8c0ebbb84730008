#pragma once

#include <string>

#include "reports/figure.h"
#include "workflow/state_prediction.h"

namespace pendular {

/// Figure of the emulator's stress ratio and solid fraction along a curve with their standard
/// errors, and of the emulator's runs near the curve: all quantities but the varied one, and the
/// stiffness number, agree within 5 %.
Figure prediction_figure(const PredictionCurve& curve, const Emulator& emulator);

/// CSV of a curve, one row per state: the state, then every observable with its standard error.
std::string prediction_table(const PredictionCurve& curve);

}  // namespace pendular
