#pragma once

#include <string>
#include <vector>

#include "calib/emulated_state.h"
#include "reports/figure.h"

namespace pendular {

/// What the emulator says along a line of states.
struct PredictionCurve {
    std::string variable;  ///< "friction", "inertial_number", "reduced_pressure", "bridge_volume"
                           ///< or "liquid_content"
    std::vector<double> at;
    std::vector<FlowState> states;
    std::vector<std::vector<EmulatedObservable>> observables;  ///< by state
    double stiffness_number = 1000;
};

/// Stress ratio and solid fraction along the curve with their standard errors, beside the runs that
/// differ from it in the varied quantity alone, up to 5 %, and in stiffness not by more than that.
Figure prediction_figure(const PredictionCurve& curve, const Emulator& emulator);

/// The curve as CSV: the states, then every observable with its standard error.
std::string prediction_table(const PredictionCurve& curve);

}  // namespace pendular
