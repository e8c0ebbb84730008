#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pendular {

/// Named set of simulation settings that balance accuracy against computing time: number of grains,
/// stiffness number, lowest inertial number, and strain over which the simulations of a study are
/// averaged.
struct Fidelity {
    std::string name;  ///< name of the set of simulation settings: "quick", "standard" or "paper"
    int grains = 0;    ///< number of grains in each simulation
    double stiffness_number = 0;  ///< stiffness number of the contacts in each simulation [1]
    /// Lowest inertial number that is simulated [1]. Predictions at lower inertial numbers are
    /// extrapolated.
    double lowest_inertial_number = 0;
    double strain = 0;  ///< shear strain over which each simulation averages [1]
};

/// Returns the set of simulation settings with the name "quick", "standard" or "paper".
/// @throws InputError for any other name; the message lists the three names
Fidelity fidelity_named(std::string_view name);

/// All sets of simulation settings, "quick", "standard" and "paper", in the order of increasing
/// computing time.
const std::vector<Fidelity>& fidelities();

}  // namespace pendular
