#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pendular {

/// Named set of simulation settings for a study: sample size, stiffness, slowest shear and averaged
/// strain.
struct Fidelity {
    std::string name;
    int grains = 0;               ///< number of grains in a run
    double stiffness_number = 0;  ///< stiffness number kappa [1]
    /// Lowest simulated inertial number I [1]. Predictions at lower I are extrapolated from runs at
    /// this I and above.
    double lowest_inertial_number = 0;
    double strain = 0;  ///< averaged strain of one run [1]
};

/// Returns the fidelity with this name: quick, standard or paper.
/// @throws InputError for any other name, naming the three fidelities
Fidelity fidelity_named(std::string_view name);

/// All fidelities, in order of increasing cost.
const std::vector<Fidelity>& fidelities();

}  // namespace pendular
