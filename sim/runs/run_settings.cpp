#include "sim/runs/run_settings.h"

#include <fmt/format.h>

#include <algorithm>

#include "data/input_error.h"

namespace pendular {

// The stiffness number 1000 is that of most runs of the atlas; 8400 and the inertial number 1e-3
// are those of Badetti et al. (2018). The number of grains and the strain set the noise of a run.
const std::vector<Fidelity>& fidelities() {
    static const std::vector<Fidelity> all = {{"quick", 1000, 1000, 3e-3, 5},
                                              {"standard", 2000, 1000, 2e-3, 10},
                                              {"paper", 4000, 8400, 1e-3, 20}};
    return all;
}

Fidelity fidelity_named(std::string_view name) {
    const auto found = std::ranges::find(fidelities(), name, &Fidelity::name);
    if (found == fidelities().end()) {
        throw InputError(fmt::format("unknown fidelity '{}'; use quick, standard or paper", name));
    }
    return *found;
}

}  // namespace pendular
