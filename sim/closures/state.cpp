#include "sim/closures/state.h"

namespace pendular::closures {

State network_state_of(const dem::RunResult& run) {
    using enum dem::Observable;
    State state;
    state.solid_fraction = run[solid_fraction].value;
    state.contact_coordination = run[contact_coordination].value;
    state.contact_force = run[contact_force].value;
    state.fabric_12_contact = run[fabric_12_contact].value;
    if (!run.parameters.wetting) return state;
    state.reduced_pressure = run.parameters.wetting->reduced_pressure;
    state.distant_coordination = run[distant_coordination].value;
    state.distant_force = run[distant_force].value;
    state.distant_force_gap = run[distant_force_gap].value;
    state.distant_length = run[distant_length].value;
    state.fabric_12_distant = run[fabric_12_distant].value;
    state.force_anisotropy_12_distant = run[force_anisotropy_12_distant].value;
    state.length_anisotropy_12_distant = run[length_anisotropy_12_distant].value;
    return state;
}

CapillaryStress capillary_stress_of(const dem::RunResult& run) {
    if (!run.parameters.wetting) return {};
    const double reduced_pressure = run.parameters.wetting->reduced_pressure;
    return {.normal = run[dem::Observable::capillary_stress_22].value * reduced_pressure,
            .shear = run[dem::Observable::capillary_shear_stress].value * reduced_pressure};
}

}  // namespace pendular::closures
