#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pendular {

/// Fidelity: named set of simulation settings that balances accuracy against computing time. The
/// settings are the number of grains, the stiffness number, the lowest inertial number, and the
/// strain over which the simulations of a study are averaged.
struct Fidelity {
    std::string name;  ///< name of the set of simulation settings: "quick", "standard" or "paper"
    int grains = 0;    ///< number of grains in each simulation
    double stiffness_number = 0;  ///< stiffness number of the contacts in each simulation [1]
    /// Lowest inertial number that is simulated [1]. Predictions at lower inertial numbers are
    /// extrapolated.
    double lowest_inertial_number = 0;
    double strain = 0;  ///< shear strain over which each simulation is averaged [1]
};

/// Returns the set of simulation settings with the name "quick", "standard" or "paper".
/// @throws InputError for any other name; the message lists the three names
Fidelity fidelity_named(std::string_view name);

/// Returns all sets of simulation settings, "quick", "standard" and "paper", in the order of
/// increasing computing time.
const std::vector<Fidelity>& fidelities();

}  // namespace pendular
