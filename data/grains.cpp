#include "data/grains.h"

#include <cmath>
#include <numbers>

namespace pendular {

double GrainProperties::mass() const {
    return density * std::numbers::pi * std::pow(diameter, 3) / 6;
}

double inertial_number(double shear_rate, double normal_stress, const GrainProperties& grains) {
    return shear_rate * std::sqrt(grains.mass() / (grains.diameter * normal_stress));
}

double shear_rate_at(double inertial_number, double normal_stress, const GrainProperties& grains) {
    return inertial_number * std::sqrt(grains.diameter * normal_stress / grains.mass());
}

std::optional<double> stiffness_number(double normal_stress, const GrainProperties& grains) {
    if (!grains.youngs_modulus) return std::nullopt;
    const double effective =
        *grains.youngs_modulus / (1 - grains.poisson_ratio * grains.poisson_ratio);
    return std::pow(effective / normal_stress, 2.0 / 3);
}

double pull_off_force(const GrainProperties& grains, const Liquid& liquid) {
    return std::numbers::pi * grains.diameter * liquid.surface_tension *
           std::cos(liquid.contact_angle);
}

double reduced_pressure(double normal_stress, const GrainProperties& grains, const Liquid& liquid) {
    return grains.diameter * grains.diameter * normal_stress / pull_off_force(grains, liquid);
}

}  // namespace pendular
