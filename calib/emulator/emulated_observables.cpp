#include "calib/emulator/emulated_observables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pendular::emulated {
namespace {

using dem::Observable;

/// Lowest stiffness number [1] for which the correction to rigid grains was measured.
constexpr double softest = 300;

/// Largest ratio between the stiffness numbers of runs that train a process together [1]. Chosen:
/// runs of other stiffness numbers train the response to stiffness instead (`Emulator`).
constexpr double stiffness_factor = 2;

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
    return of_bridges(which)                           ? Domain::bridges
           : which == Observable::contact_coordination ? Domain::contacts
                                                       : Domain::all_flow;
}

bool alike(double a_stiffness_number, double another) {
    return std::max(a_stiffness_number, another) <=
           stiffness_factor * std::min(a_stiffness_number, another);
}

bool has_value(const dem::RunResult& run, Observable which) {
    return run.parameters.wetting || !of_bridges(which);
}

Coordinates place_of(const FlowState& state) {
    Coordinates at = coordinates(state, friction_centre, exponent);
    at.x = std::log((state.friction + friction_scale) / (friction_centre + friction_scale));
    return at;
}

bool of_bridges(Observable which) {
    // Z* counts distant bridges, which exist at any pull-off force and are absent in dry flow.
    return dem::needs_bridges(which) || which == Observable::effective_coordination;
}

std::string why_unusable(const dem::RunResult& run) {
    if (!run.failure.empty()) return "failed, " + run.failure;
    if (run.crystallised) return "crystallised";
    if (!run.steady) return "was not steady";
    if (run[dem::Observable::localization].value > banded_above) return "sheared in a band";
    if (run.parameters.damping != dem::RunParameters{}.damping) {
        return "has contacts with another damping than the default";
    }
    if (run.parameters.stiffness_number < softest) {
        return fmt::format("has a stiffness number below {}", softest);
    }
    return "";
}

FlowState flow_state_of(const dem::RunParameters& p) {
    FlowState state{p.friction, p.inertial_number};
    if (p.wetting) {
        state.inverse_pressure = 1 / p.wetting->reduced_pressure;
        state.bridge_volume = p.wetting->bridge_volume;
    }
    state.effects = p.effects;
    state.stiffness_number = p.stiffness_number;
    return state;
}

Mean training_value(const dem::RunResult& run, Observable which) {
    Mean mean = run[which];
    if (which == Observable::solid_fraction) {
        mean.value -= dem::rigidity_shift(mean.value, run[Observable::overlap].value);
    } else if (which == Observable::overlap) {
        const double factor = run.parameters.stiffness_number / reference_stiffness;
        mean.value *= factor;
        mean.standard_error *= factor;
    }
    return mean;
}

const std::vector<Observable>& observables() {
    // All observables except imposed quantities, quantities that reveal a crystal, and parts of the
    // dissipation.
    static const std::vector<Observable> all = [] {
        using enum Observable;
        std::vector<Observable> emulated;
        for (std::size_t k = 0; k < dem::observable_count; ++k) {
            const auto which = static_cast<Observable>(k);
            if (which < dissipation_friction && which != held_normal_stress &&
                which != bond_order) {
                emulated.push_back(which);
            }
        }
        return emulated;
    }();
    return all;
}

}  // namespace pendular::emulated
