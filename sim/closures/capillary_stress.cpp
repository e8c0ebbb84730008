#include "sim/closures/capillary_stress.h"

#include <numbers>

namespace pendular::closures {
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
