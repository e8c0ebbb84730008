#include "calib/emulated_observables.h"

#include <cmath>

namespace pendular::emulated {
namespace {

using dem::Observable;

/// Structure is that of beads of about this stiffness.
constexpr double stiffness_factor = 2;

bool depends_on_stiffness(Observable which) {
    return !in_pair(which) && which != Observable::mean_overlap &&
           which != Observable::first_normal_stress_difference &&
           which != Observable::second_normal_stress_difference;
}

}  // namespace

bool in_pair(Observable which) {
    return which == pair[0] || which == pair[1];
}

std::vector<Query> pairs_at(const std::vector<FlowState>& states) {
    std::vector<Query> queries;
    for (const FlowState& state : states) {
        queries.push_back({state, pair[0]});
        queries.push_back({state, pair[1]});
    }
    return queries;
}

Unit unit_at(Observable which, const FlowState& state) {
    using enum Observable;
    switch (which) {
        case capillary_stress_22:
        case capillary_pressure:
        case capillary_shear_stress:
        case capillary_shear_stress_contact:
        case capillary_shear_stress_distant:
            return {.size = state.inverse_pressure, .by_inverse_pressure = 1};
        case distant_length: {
            const double rupture_distance = std::cbrt(state.bridge_volume);
            return {.offset = 1,
                    .size = rupture_distance,
                    .by_bridge_volume = rupture_distance / (3 * state.bridge_volume)};
        }
        default:
            return {};
    }
}

Domain domain_of(Observable which) {
    return Emulator::of_bridges(which)                 ? Domain::bridges
           : which == Observable::contact_coordination ? Domain::contacts
                                                       : Domain::all_flow;
}

bool tells(const dem::RunResult& run, Observable which) {
    const double stiffness = run.parameters.stiffness_number / Emulator::reference_stiffness;
    return (run.parameters.wetting || !Emulator::of_bridges(which)) &&
           (!depends_on_stiffness(which) ||
            (stiffness <= stiffness_factor && stiffness >= 1 / stiffness_factor));
}

Coordinates place_of(const FlowState& state) {
    Coordinates at = coordinates(state, friction_centre, exponent);
    at.x = std::log((state.friction + friction_scale) / (friction_centre + friction_scale));
    return at;
}

}  // namespace pendular::emulated
