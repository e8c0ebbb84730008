#include "sim/closures/state.h"

#include <numbers>

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

namespace {

using std::numbers::pi;

/// (Z_d F_d/F0) (l0/a) Phi [1]: factor of the anisotropies in the stress of distant pairs.
double distant_moment(const State& s) {
    return s.solid_fraction * s.distant_coordination * s.distant_force * s.distant_length;
}

}  // namespace

double effective_coordination(const State& s) {
    return s.contact_coordination + s.distant_coordination * s.distant_force;
}

double approximate_coordination(const State& s) {
    return s.contact_coordination + s.distant_coordination * usual_distant_force;
}

double mean_stress(const State& s) {
    const double contact = s.solid_fraction * s.contact_coordination * s.contact_force / pi;
    return contact + capillary_pressure(s) / s.reduced_pressure;
}

double capillary_pressure(const State& s) {
    const double gaps = s.distant_coordination * s.distant_force_gap;
    return capillary_pressure(s.solid_fraction, effective_coordination(s) + gaps);
}

double capillary_pressure(double solid_fraction, double effective_coordination) {
    return -effective_coordination * solid_fraction / pi;
}

double contact_capillary_shear_stress(const State& s) {
    return -3 / pi * s.solid_fraction * s.contact_coordination * s.fabric_12_contact;
}

double distant_capillary_shear_stress(const State& s) {
    return -3 / pi * distant_moment(s) *
           (s.fabric_12_distant + s.force_anisotropy_12_distant + s.length_anisotropy_12_distant);
}

double capillary_shear_stress(const State& s) {
    return contact_capillary_shear_stress(s) -
           3 / pi * distant_moment(s) * (s.fabric_12_distant + s.force_anisotropy_12_distant);
}

}  // namespace pendular::closures
