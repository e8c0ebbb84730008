#pragma once

#include <vector>

#include "calib/emulator/query.h"

namespace pendular::emulated {

/// Stiffness number at which overlaps are emulated, and structure where nothing else is said.
constexpr double reference_stiffness = 1000;

/// Whether a run can serve as a training run.
bool usable(const dem::RunResult& run);
/// Training value of an observable from a run, with its standard error.
Mean training_value(const dem::RunResult& run, dem::Observable which);
FlowState flow_state_of(const dem::RunParameters& run);
/// Whether an observable is defined for wet grains only.
bool of_bridges(dem::Observable which);
/// All observables that are emulated.
const std::vector<dem::Observable>& observables();

// Over which coordinates and in which units each observable is emulated.

/// Coordinate of friction: about ln(friction), straight below 0.02, where flow changes fastest.
inline constexpr double friction_scale = 0.02, friction_centre = 0.1;
/// Coordinate of the inertial number: I^0.5.
inline constexpr double exponent = 0.5;

/// Stress ratio and solid fraction share one process.
inline constexpr dem::Observable pair[] = {dem::Observable::stress_ratio,
                                           dem::Observable::solid_fraction};
bool in_pair(dem::Observable which);
/// Queries of stress ratio and solid fraction at these states, in turn.
std::vector<Query> pairs_at(const std::vector<FlowState>& states);

/// Scaling of an observable before emulation, chosen so that the emulated remainder varies little:
/// value = offset + size x process. Capillary stresses over s22 go with 1/P*, the gap of distant
/// pairs with the rupture distance.
struct Unit {
    double offset = 0, size = 1;
    double by_inverse_pressure = 0, by_bridge_volume = 0;  ///< derivatives of `size`
};
Unit unit_at(dem::Observable which, const FlowState& state);

Domain domain_of(dem::Observable which);

/// Whether a run says something of an observable, be it with effects or without; of structure where
/// its stiffness number is within a factor 2 of this one.
bool tells(const dem::RunResult& run, dem::Observable which, double structure_stiffness);

Coordinates place_of(const FlowState& state);

}  // namespace pendular::emulated
