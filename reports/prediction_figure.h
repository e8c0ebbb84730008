#pragma once

#include <string>

#include "reports/figure.h"
#include "workflow/state_prediction.h"

namespace pendular {

/// Stress ratio and solid fraction along the curve with their standard errors, beside the runs that
/// differ from it in the varied quantity alone, up to 5 %, and in stiffness not by more than that.
Figure prediction_figure(const PredictionCurve& curve, const Emulator& emulator);

/// Curve as CSV: the states, then every observable with its standard error.
std::string prediction_table(const PredictionCurve& curve);

}  // namespace pendular
