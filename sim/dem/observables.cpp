#include "sim/dem/observables.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

namespace pendular::dem {

bool needs_bridges(Observable which) {
    using enum Observable;
    switch (which) {
        case distant_coordination:
        case liquid_content:
        case fabric_12_distant:
        case force_anisotropy_12_distant:
        case length_anisotropy_12_distant:
        case distant_force:
        case distant_force_gap:
        case distant_length:
        case capillary_stress_22:
        case capillary_pressure:
        case capillary_shear_stress:
        case capillary_shear_stress_contact:
        case capillary_shear_stress_distant:
        case dissipation_bridges:
            return true;
        default:
            return false;
    }
}

Observable observable_named(std::string_view name) {
    const auto found = std::ranges::find(observable_names, name);
    if (found == observable_names.end()) {
        throw std::invalid_argument(fmt::format("unknown observable '{}'; use one of {}", name,
                                                fmt::join(observable_names, ", ")));
    }
    return static_cast<Observable>(found - observable_names.begin());
}

}  // namespace pendular::dem
