#pragma once

#include <string>
#include <vector>

#include "calib/emulator/query.h"

namespace pendular::emulated {

/// Reference value of the emulator [1] for the stiffness number (E/((1 - nu^2) s22))^(2/3), with
/// Young's modulus E, Poisson ratio nu and normal stress s22. By default, the Gaussian processes of
/// the emulator are trained on runs whose stiffness number is within a factor of 2 of the
/// reference. The emulator predicts the mean overlap of contacts for the reference stiffness
/// number.
constexpr double reference_stiffness = 1000;

/// Localization D of the shear [1] above which a run counts as sheared in a band. The emulator is
/// not trained on such a run. D is 0 for uniform shear and 1 for an infinitely thin band. A band
/// between rigid blocks has the height 1 - sqrt(D), relative to the height of the sample. Small
/// samples that shear uniformly reach D = 0.11 at low reduced pressure.
constexpr double banded_above = 0.2;

/// Returns the reason why an emulator cannot be trained on a run, such as "crystallised" or "was
/// not steady". The text is the predicate of a sentence whose subject is the run. The text is empty
/// if the run is `usable`.
std::string why_unusable(const dem::RunResult& run);

/// Whether an emulator can be trained on a run. The run must have succeeded and be steady, and must
/// not have crystallised or sheared in a band (`banded_above`). The damping of contacts must have
/// the default value of `dem::RunParameters`, and the stiffness number must be at least 300.
inline bool usable(const dem::RunResult& run) {
    return why_unusable(run).empty();
}
/// Returns the value of an observable in a run, as used to train the emulator, with the standard
/// error of the value, both in the unit of the observable. The value is the average measured in the
/// run, with two exceptions: the solid fraction is corrected to rigid grains, and the mean overlap
/// is converted to the stiffness number `reference_stiffness`.
Mean training_value(const dem::RunResult& run, dem::Observable which);
/// Returns the state of steady shear that a run with the parameters `run` simulates. The state
/// includes the effects on grains and the stiffness number.
FlowState flow_state_of(const dem::RunParameters& run);
/// Whether an observable is emulated for wet grains only, since the observable describes liquid
/// bridges.
bool of_bridges(dem::Observable which);
/// Returns all emulated observables, in the order of `dem::Observable`. Three kinds of observables
/// are not emulated: the measured normal stress, the bond order, and the dissipated energies
/// (`dissipation_friction` and the following observables).
const std::vector<dem::Observable>& observables();

// Coordinates and units in which each observable is emulated.

/// Constants of the emulator's coordinate of the friction coefficient [1],
///     x = ln[(friction + friction_scale)/(friction_centre + friction_scale)].
/// The coordinate x is nearly linear in the friction coefficient below 0.02, where the flow changes
/// fastest with the friction coefficient.
inline constexpr double friction_scale = 0.02, friction_centre = 0.1;
/// Exponent [1] of the emulator's coordinate q = I^0.5 of the inertial number I.
inline constexpr double exponent = 0.5;

/// Stress ratio and solid fraction, in this order. Both observables share one Gaussian process of
/// two quantities, since the noise of the two observables is correlated within a run.
inline constexpr dem::Observable pair[] = {dem::Observable::stress_ratio,
                                           dem::Observable::solid_fraction};
/// Whether an observable is in the list `pair`, which contains stress ratio and solid fraction.
bool in_pair(dem::Observable which);
/// Returns two queries to the emulator for each of `states` in turn: a query for the stress ratio,
/// then a query for the solid fraction.
std::vector<Query> pairs_at(const std::vector<FlowState>& states);

/// Scaling between an observable and the Gaussian process that predicts the observable, at one
/// state of steady shear: value = offset + size x process. For capillary stresses divided by the
/// normal stress, `size` is 1/P*, with the reduced pressure P*. For the distance of grains with a
/// bridge but no contact, `size` is the gap at which the bridge breaks, divided by the grain
/// diameter, and `offset` is 1. For all other observables, `size` is 1.
struct Unit {
    double offset = 0, size = 1;
    /// Derivatives of `size` with respect to 1/P* (`by_inverse_pressure`) and with respect to
    /// V0/a^3 (`by_bridge_volume`), with the reduced pressure P*, the bridge volume V0 and the
    /// grain diameter a.
    double by_inverse_pressure = 0, by_bridge_volume = 0;
};
/// Returns the scaling, value = offset + size x process, between an observable and the Gaussian
/// process that predicts the observable, at a state of steady shear.
Unit unit_at(dem::Observable which, const FlowState& state);

/// Returns the kind of an observable, which determines the behaviour of the observable in the dry
/// limit, as the reduced pressure P* becomes infinite.
Domain domain_of(dem::Observable which);

/// Whether two stiffness numbers [1] of runs differ by at most a factor of 2. A Gaussian process is
/// trained only on runs whose stiffness numbers are alike in this sense.
bool alike(double a_stiffness_number, double another);

/// Whether a run has a value of an observable. For observables of liquid bridges, the run must be
/// wet.
bool has_value(const dem::RunResult& run, dem::Observable which);

/// Returns the coordinates of a state of steady shear in which all Gaussian processes of the
/// emulator are defined,
///     x = ln[(friction + friction_scale)/(friction_centre + friction_scale)],
///     q = sqrt(I),  u = 1/P*,  v = ln(V0/a^3/0.002),
/// with the inertial number I, the reduced pressure P*, the bridge volume V0 and the grain diameter
/// a. For dry grains, v = 0.
Coordinates place_of(const FlowState& state);

}  // namespace pendular::emulated
