#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pendular {

/// Named set of simulation settings that balances accuracy against computing time.
struct Fidelity {
    std::string name;  ///< "quick", "standard" or "paper"
    int grains = 0;
    double stiffness_number = 0;  ///< [1]
    /// Lowest inertial number that is simulated [1]; predictions below are extrapolated.
    double lowest_inertial_number = 0;
    double strain = 0;  ///< over which each simulation of a study is averaged [1]
};

/// Returns the settings named "quick", "standard" or "paper".
/// @throws InputError for any other name; the message lists the three names
Fidelity fidelity_named(std::string_view name);

/// Returns all sets of settings in the order of increasing computing time.
const std::vector<Fidelity>& fidelities();

}  // namespace pendular
