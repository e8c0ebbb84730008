#include "calib/emulator/emulated_structure.h"

#include <algorithm>
#include <cmath>

namespace pendular {

using dem::Observable;

StructureResponse respond(const Emulator& emulator, const std::vector<Observable>& sum,
                          const FlowState& state) {
    StructureResponse response;
    for (const Observable which : sum) {
        const Eigen::VectorXd found = emulator.mean({{state, which},
                                                     {state, which, Input::friction},
                                                     {state, which, Input::bridge_volume}});
        response.value += found(0);
        response.by_friction += found(1);
        response.by_log_volume += found(2) * state.bridge_volume;
    }
    return response;
}

StructureResponse coordination(const Emulator& emulator, const FlowState& state) {
    return respond(emulator, {Observable::contact_coordination, Observable::distant_coordination},
                   state);
}

double bridge_volume_of(const Emulator& emulator, double liquid_content, FlowState state) {
    // ln V0 + ln Z(V0) = ln(pi Phi_L/(3 Phi_S)), by Newton's method: the error of the next step is
    // about the square of this one.
    constexpr double tolerance = 1e-4;
    state.bridge_volume = dem::bridge_volume(liquid_content, dem::typical_coordination);
    for (int k = 0; k < 50; ++k) {
        const StructureResponse z = coordination(emulator, state);
        const double value = std::max(1.0, z.value);
        // At least 0.5: the step is at most twice that of a constant Z, also where Z(V0) falls.
        const double step =
            std::log(dem::bridge_volume(liquid_content, value) / state.bridge_volume) /
            std::max(0.5, 1 + z.by_log_volume / value);
        state.bridge_volume *= std::exp(step);
        if (std::abs(step) < tolerance) {
            break;
        }
    }
    return state.bridge_volume;
}

}  // namespace pendular
