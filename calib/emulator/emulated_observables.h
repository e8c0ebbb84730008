#pragma once

#include <vector>

#include "calib/emulator/query.h"

namespace pendular::emulated {

/// Stiffness number [1] for which overlaps are emulated. By default it is also that of the runs
/// that train the emulator's Gaussian processes, within a factor 2.
constexpr double reference_stiffness = 1000;

/// Localization above which a run does not train the emulator [1]: shear gathers in half of the
/// height or less, since a localization D is that of a band of 1 - sqrt(D) of the height between
/// rigid blocks. Small samples of uniform flow at low P* reach 0.11.
constexpr double banded_above = 0.2;

/// Whether a run can serve as a training run of an emulator: it succeeded, was steady, did not
/// crystallise or shear in a band (`banded_above`), and has the standard damping and a stiffness
/// number of at least 300.
bool usable(const dem::RunResult& run);
/// Value of an observable of a run on which the emulator is trained, with its standard error: as
/// measured in the run, but the solid fraction is corrected to rigid grains and the overlap is
/// converted to `reference_stiffness`.
Mean training_value(const dem::RunResult& run, dem::Observable which);
/// Flow state that a run with these parameters simulates, with its effects on grains.
FlowState flow_state_of(const dem::RunParameters& run);
/// Whether an observable is emulated for wet grains only.
bool of_bridges(dem::Observable which);
/// All emulated observables, in the order of `dem::Observable`.
const std::vector<dem::Observable>& observables();

// Coordinates and units in which each observable is emulated.

/// Constants of the emulator's coordinate of friction [1],
///     x = ln[(friction + friction_scale)/(friction_centre + friction_scale)],
/// which is nearly linear in friction below 0.02, where flow changes fastest with friction.
inline constexpr double friction_scale = 0.02, friction_centre = 0.1;
/// Exponent [1] of the emulator's coordinate of the inertial number I, q = I^0.5.
inline constexpr double exponent = 0.5;

/// Stress ratio and solid fraction, which share one Gaussian process of two quantities, since the
/// noise of a run correlates them.
inline constexpr dem::Observable pair[] = {dem::Observable::stress_ratio,
                                           dem::Observable::solid_fraction};
/// Whether an observable is one of `pair`: stress ratio or solid fraction.
bool in_pair(dem::Observable which);
/// Two queries for each state, in the order of `states`: its stress ratio, then its solid fraction.
std::vector<Query> pairs_at(const std::vector<FlowState>& states);

/// Scaling of an observable for emulation: value = offset + size x Gaussian process. It is chosen
/// so that the process varies little: `size` is 1/P* for capillary stresses over s22, and the
/// rupture distance for the gap of distant pairs.
struct Unit {
    double offset = 0, size = 1;
    /// Derivatives of `size` by 1/P* and V0/a^3.
    double by_inverse_pressure = 0, by_bridge_volume = 0;
};
/// Scaling between an observable and its Gaussian process at a flow state.
Unit unit_at(dem::Observable which, const FlowState& state);

/// Kind of an observable, which decides how the observable behaves in the dry limit 1/P* -> 0.
Domain domain_of(dem::Observable which);

/// Whether runs of two stiffness numbers [1] can train a Gaussian process together: they differ by
/// at most a factor 2.
bool alike(double a_stiffness_number, double another);

/// Whether a run, with or without effects, has a value of an observable, which for observables of
/// bridges takes a wet run.
bool has_value(const dem::RunResult& run, dem::Observable which);

/// Coordinates of a flow state that the Gaussian processes of all observables use.
Coordinates place_of(const FlowState& state);

}  // namespace pendular::emulated
