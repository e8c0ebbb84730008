#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace pendular::dem {

/// What a run measures. Names, symbols and meanings stand in `observable_names`. Capillary
/// observables are zero in dry runs.
enum class Observable {
    stress_ratio,
    solid_fraction,
    contact_coordination,
    distant_coordination,
    liquid_content,
    fabric_12_contact,
    fabric_12_distant,
    force_anisotropy_12_contact,
    force_anisotropy_12_distant,
    length_anisotropy_12_distant,
    contact_force,
    distant_force,
    distant_force_gap,
    distant_length,
    effective_coordination,
    capillary_stress_22,
    capillary_pressure,
    capillary_shear_stress,
    capillary_shear_stress_contact,
    capillary_shear_stress_distant,
    first_normal_stress_difference,
    second_normal_stress_difference,
    localization,
    mean_overlap,
    bond_order,
    held_normal_stress,
    dissipation_friction,
    dissipation_viscosity,
    dissipation_bridges,
    dissipation_springs,
};
constexpr std::array observable_names =
    std::to_array<std::string_view>({"stress_ratio",
                                     "solid_fraction",
                                     "contact_coordination",
                                     "distant_coordination",
                                     "liquid_content",
                                     "fabric_12_contact",
                                     "fabric_12_distant",
                                     "force_anisotropy_12_contact",
                                     "force_anisotropy_12_distant",
                                     "length_anisotropy_12_distant",
                                     "contact_force",
                                     "distant_force",
                                     "distant_force_gap",
                                     "distant_length",
                                     "effective_coordination",
                                     "capillary_stress_22",
                                     "capillary_pressure",
                                     "capillary_shear_stress",
                                     "capillary_shear_stress_contact",
                                     "capillary_shear_stress_distant",
                                     "first_normal_stress_difference",
                                     "second_normal_stress_difference",
                                     "localization",
                                     "overlap",
                                     "bond_order",
                                     "held_normal_stress",
                                     "dissipation_friction",
                                     "dissipation_viscosity",
                                     "dissipation_bridges",
                                     "dissipation_springs"});
constexpr std::size_t observable_count = observable_names.size();
static_assert(static_cast<std::size_t>(Observable::dissipation_springs) + 1 == observable_count);

/// Whether an observable says nothing of dry beads.
bool needs_bridges(Observable which);

/// Observable of a name in `observable_names`.
/// @throws std::invalid_argument naming those there are
Observable observable_named(std::string_view name);

}  // namespace pendular::dem
