#pragma once

#include <string>

#include "reports/figure.h"
#include "workflow/state_prediction.h"

namespace pendular {

/// Figure of stress ratio and solid fraction along a curve of flow states, as the emulator (which
/// interpolates between simulation runs) predicts them, with standard errors; and of the emulator's
/// runs near the curve, whose other quantities and stiffness number agree with it within 5 %.
Figure prediction_figure(const PredictionCurve& curve, const Emulator& emulator);

/// CSV of a predicted curve, one row per flow state: friction, inertial number, reduced pressure
/// and bridge volume (both empty: dry), then every predicted observable with its standard error.
std::string prediction_table(const PredictionCurve& curve);

}  // namespace pendular
