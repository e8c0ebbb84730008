#pragma once

#include <vector>

#include "calib/emulator/query.h"

namespace pendular::emulated {

/// Stiffness number [1] for which mean overlaps of contacts are emulated. By default, the
/// emulator's Gaussian processes are trained on runs of this stiffness number, within a factor 2.
constexpr double reference_stiffness = 1000;

/// Localization of the shear [1] above which a run does not train the emulator. If the grains shear
/// only in a band between rigid blocks, and the localization is D, the band takes the share 1 -
/// sqrt(D) of the height: about half or less for D above 0.2. In small samples that shear
/// uniformly, D reaches 0.11 at low reduced pressure.
constexpr double banded_above = 0.2;

/// Whether a run can train an emulator: it succeeded, was steady, did not crystallise or shear in a
/// band (`banded_above`), and has the standard damping of contacts and a stiffness number of at
/// least 300.
bool usable(const dem::RunResult& run);
/// Returns the value of an observable on which a run trains the emulator, with its standard error.
/// It is the value measured in the run, except that the solid fraction is corrected to rigid grains
/// and the mean overlap is converted to the stiffness number `reference_stiffness`.
Mean training_value(const dem::RunResult& run, dem::Observable which);
/// Returns the state of steady shear that a run with these parameters simulates, including its
/// effects on grains and its stiffness number.
FlowState flow_state_of(const dem::RunParameters& run);
/// Whether an observable is emulated for wet grains only, since it describes liquid bridges.
bool of_bridges(dem::Observable which);
/// All emulated observables, in the order of `dem::Observable`. Not emulated are the measured
/// normal stress, the bond order and the parts of the dissipation.
const std::vector<dem::Observable>& observables();

// Coordinates and units in which each observable is emulated.

/// Constants of the emulator's coordinate of the friction coefficient [1],
///     x = ln[(friction + friction_scale)/(friction_centre + friction_scale)].
/// x is nearly linear in friction below 0.02, where flow changes fastest with friction.
inline constexpr double friction_scale = 0.02, friction_centre = 0.1;
/// Exponent [1] of the emulator's coordinate of the inertial number I, q = I^0.5.
inline constexpr double exponent = 0.5;

/// Stress ratio and solid fraction. They share one Gaussian process of two quantities, since their
/// noise is correlated within a run.
inline constexpr dem::Observable pair[] = {dem::Observable::stress_ratio,
                                           dem::Observable::solid_fraction};
/// Whether an observable is one of `pair`: stress ratio or solid fraction.
bool in_pair(dem::Observable which);
/// Returns two queries to the emulator for each state, in the order of `states`: for its stress
/// ratio, then for its solid fraction.
std::vector<Query> pairs_at(const std::vector<FlowState>& states);

/// Scaling between an observable and the Gaussian process that predicts it, at one state of steady
/// shear: value = offset + size x process. `size` is 1/P* (P*: reduced pressure) for capillary
/// stresses, which are divided by the normal stress. For the distance of grains that have a bridge
/// but no contact, it is the gap at which the bridge breaks, divided by the grain diameter. For
/// other observables it is 1.
struct Unit {
    double offset = 0, size = 1;
    /// Derivatives of `size` with respect to 1/P* (`by_inverse_pressure`) and to V0/a^3
    /// (`by_bridge_volume`). P*: reduced pressure; V0: bridge volume; a: grain diameter.
    double by_inverse_pressure = 0, by_bridge_volume = 0;
};
/// Returns the scaling, value = offset + size x process, between an observable and the Gaussian
/// process that predicts it, at a state of steady shear.
Unit unit_at(dem::Observable which, const FlowState& state);

/// Returns the kind of an observable, which determines its behaviour in the dry limit, as the
/// reduced pressure P* becomes infinite.
Domain domain_of(dem::Observable which);

/// Whether the stiffness numbers [1] of two runs differ by at most a factor 2, so that runs with
/// them may train one Gaussian process together.
bool alike(double a_stiffness_number, double another);

/// Whether a run has a value of an observable. Observables of liquid bridges need a wet run.
bool has_value(const dem::RunResult& run, dem::Observable which);

/// Returns the coordinates in which the Gaussian processes of all observables are defined, at a
/// state of steady shear. They are x = ln[(friction + `friction_scale`)/(`friction_centre` +
/// `friction_scale`)], q = sqrt(I), u = 1/P* and v = ln(V0/a^3/0.002), or v = 0 for dry grains. I:
/// inertial number; P*: reduced pressure; V0: bridge volume; a: grain diameter.
Coordinates place_of(const FlowState& state);

}  // namespace pendular::emulated
