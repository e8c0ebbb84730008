#pragma once

#include <vector>

#include "calib/emulator/query.h"

namespace pendular::emulated {

/// Stiffness number [1] at which overlaps are emulated, and by default the structure: coordination
/// numbers, capillary stresses and others that depend weakly on stiffness.
constexpr double reference_stiffness = 1000;

/// Whether a run can serve as a training run: it succeeded, was steady, did not crystallise, and
/// has the standard damping and a stiffness number of at least 300.
bool usable(const dem::RunResult& run);
/// Value of an observable on which the emulator is trained, with its standard error: as measured in
/// the run, but the solid fraction is corrected to rigid grains and the overlap is converted to
/// `reference_stiffness`.
Mean training_value(const dem::RunResult& run, dem::Observable which);
/// Flow state that a run simulates, with its effects on grains.
FlowState flow_state_of(const dem::RunParameters& run);
/// Whether an observable is defined for wet grains only.
bool of_bridges(dem::Observable which);
/// All emulated observables, in the order of `dem::Observable`.
const std::vector<dem::Observable>& observables();

// Coordinates and units in which each observable is emulated.

/// Constants of the emulator's coordinate of friction,
///     x = ln[(friction + friction_scale)/(friction_centre + friction_scale)],
/// which is nearly linear in friction below 0.02, where flow changes fastest with friction.
inline constexpr double friction_scale = 0.02, friction_centre = 0.1;
/// Exponent of the emulator's coordinate of the inertial number, q = I^0.5.
inline constexpr double exponent = 0.5;

/// Observables that share one Gaussian process of two quantities, since the noise of a run
/// correlates them.
inline constexpr dem::Observable pair[] = {dem::Observable::stress_ratio,
                                           dem::Observable::solid_fraction};
/// Whether an observable is one of `pair`.
bool in_pair(dem::Observable which);
/// Two queries for each state, in the order of `states`: its stress ratio, then its solid fraction.
std::vector<Query> pairs_at(const std::vector<FlowState>& states);

/// Scaling of an observable for emulation: value = offset + size x process. It is chosen so that
/// the process varies little: capillary stresses over s22 are proportional to 1/P*, the gap of
/// distant pairs to the rupture distance.
struct Unit {
    double offset = 0, size = 1;
    double by_inverse_pressure = 0, by_bridge_volume = 0;  ///< derivatives of `size`
};
/// Scaling of an observable at a state.
Unit unit_at(dem::Observable which, const FlowState& state);

/// Kind of an observable, which decides how it behaves in the dry limit.
Domain domain_of(dem::Observable which);

/// Whether a run, with or without effects, has a training value of an observable. Observables of
/// bridges need a wet run. Observables of structure need a run whose stiffness number is within a
/// factor 2 of `structure_stiffness`.
bool tells(const dem::RunResult& run, dem::Observable which, double structure_stiffness);

/// Coordinates of a state in which all observables are emulated.
Coordinates place_of(const FlowState& state);

}  // namespace pendular::emulated
