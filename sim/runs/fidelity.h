#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pendular {

/// Settings of the simulations of a study: size, stiffness, slowest rate and length.
struct Fidelity {
    std::string name;
    int grains = 0;
    double stiffness_number = 0;        ///< kappa [1]
    double lowest_inertial_number = 0;  ///< I [1]; slower readings are extrapolated from here up
    double strain = 0;                  ///< averaged strain of one run [1]
};

/// Fidelity with this name: quick, standard or paper.
/// @throws InputError naming the nearest known one
Fidelity fidelity_named(std::string_view name);

/// All fidelities, the cheapest first.
const std::vector<Fidelity>& fidelities();

}  // namespace pendular
