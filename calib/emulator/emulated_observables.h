#pragma once

#include <string>
#include <vector>

#include "calib/emulator/query.h"

namespace pendular::emulated {

/// Reference stiffness number [1], that of most runs of the atlas: softer grains allow longer time
/// steps. By default, the emulator is trained on runs whose stiffness number is within a factor of
/// 2 of it. The mean overlap of contacts is emulated for it.
constexpr double reference_stiffness = 1000;

/// Localization D of the shear [1] above which a run counts as sheared in a band and trains no
/// emulator. A band between rigid blocks has the height 1 - sqrt(D), relative to the height of the
/// sample. Small samples that shear uniformly reach D = 0.11 at low reduced pressure.
constexpr double banded_above = 0.2;

/// Returns why an emulator cannot be trained on a run, as a predicate such as "crystallised" or
/// "was not steady"; empty if the run is `usable`.
std::string why_unusable(const dem::RunResult& run);

/// Whether an emulator can be trained on a run: it succeeded, was steady, did not crystallise or
/// shear in a band, and has the default damping of contacts and a stiffness number of at least 300.
inline bool usable(const dem::RunResult& run) {
    return why_unusable(run).empty();
}
/// Returns the training value of an observable with its standard error, in the unit of the
/// observable: the average measured in the run, except that the solid fraction is corrected to
/// rigid grains, and the mean overlap is converted to `reference_stiffness`.
Mean training_value(const dem::RunResult& run, dem::Observable which);
/// Returns the state that a run simulates, with its effects on grains and its stiffness number.
FlowState flow_state_of(const dem::RunParameters& run);
/// Whether an observable describes liquid bridges, so that it is emulated for wet grains only.
bool of_bridges(dem::Observable which);
/// Returns all emulated observables, in the order of `dem::Observable`: all but the measured normal
/// stress, the bond order, and the dissipated energies (from `dissipation_friction` on).
const std::vector<dem::Observable>& observables();

// Coordinates and units in which each observable is emulated.

/// Constants of the emulator's coordinate x (`place_of`), nearly linear in the friction coefficient
/// below 0.02, where the flow changes fastest with it.
inline constexpr double friction_scale = 0.02, friction_centre = 0.1;
/// Exponent of the emulator's coordinate q. Fitted exponents of I grow from 0.39 without friction,
/// where the flow changes fastest as I falls, to about 1 from a friction of 0.09 on
/// (docs/validation.md, Dependence on the inertial number); the process in q adapts.
inline constexpr double exponent = 0.5;

/// Observables that share one Gaussian process, as their noise is correlated within a run.
inline constexpr dem::Observable pair[] = {dem::Observable::stress_ratio,
                                           dem::Observable::solid_fraction};
bool in_pair(dem::Observable which);
/// Returns, for each state in turn, queries for the stress ratio and the solid fraction.
std::vector<Query> pairs_at(const std::vector<FlowState>& states);

/// Scaling at one state between an observable and its Gaussian process: value = offset + size x
/// process. For capillary stresses divided by the normal stress, `size` is 1/P*. For the distance
/// of grains with a bridge but no contact, `size` is the gap at which the bridge breaks, divided by
/// the grain diameter, and `offset` is 1. For all other observables, `size` is 1.
struct Unit {
    double offset = 0, size = 1;
    /// Derivatives of `size` with respect to 1/P* and to V0/a^3.
    double by_inverse_pressure = 0, by_bridge_volume = 0;
};
/// Returns the scaling of an observable at a state.
Unit unit_at(dem::Observable which, const FlowState& state);

/// Returns the kind of an observable, which determines its dry limit.
Domain domain_of(dem::Observable which);

/// Whether two stiffness numbers [1] differ by at most a factor of 2: their runs train one process.
bool alike(double a_stiffness_number, double another);

/// Whether a run has a value of an observable: it must be wet for observables of bridges.
bool has_value(const dem::RunResult& run, dem::Observable which);

/// Returns the coordinates of a state in which all Gaussian processes of the emulator are defined
/// (`Coordinates`), with s = friction_scale, centre = friction_centre and exponent 0.5.
Coordinates place_of(const FlowState& state);

}  // namespace pendular::emulated
