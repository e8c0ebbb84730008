#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "data/effect_parameter.h"
#include "sim/dem/bridge_law.h"
#include "sim/dem/observables.h"

namespace pendular::dem {

class GrainEffects;

/// Largest inertial number that can be simulated [1]. In faster flows, the sample is too dilute for
/// the servo that adjusts the height of the cell to keep the normal stress.
constexpr double largest_inertial_number = 0.5;

/// Requested precision of a simulation run: largest allowed standard error of the average of one
/// observable, in the observable's unit. A run may end early once all requested standard errors are
/// reached.
struct Precision {
    Observable which = Observable::stress_ratio;
    double standard_error = 0;
};
/// Reads an observable and the standard error at which a run may stop, written as
/// "stress_ratio=0.003".
/// @throws std::invalid_argument if the text has another form or the observable is unknown
Precision precision_named(std::string_view text);

/// Smallest shear strain over which a run must average before its standard errors are reliable [1].
constexpr double shortest_precise_strain = 2;

/// Parameters that determine one simulation run of steady shear, in reduced units (grain diameter,
/// grain mass and imposed normal stress are 1).
struct RunParameters {
    double friction = 0.09;          ///< friction coefficient between grains [1]
    double inertial_number = 1e-3;   ///< inertial number of the simulated flow [1]
    double stiffness_number = 1000;  ///< stiffness number of the contacts [1]
    double poisson_ratio = 0.3;      ///< Poisson ratio of the grains [1]
    /// Damping coefficient of the normal motion in contacts, divided by the coefficient of critical
    /// damping [1].
    double damping = 0.98;
    std::optional<Wetting> wetting;  ///< parameters of the liquid bridges, empty for dry grains
    int grains = 2000;
    double strain = 10;  ///< shear strain over which the run is averaged, without transient [1]
    std::uint64_t seed = 1;
    /// Fingerprint (hash by the function `fingerprint`) of the run whose final state is the initial
    /// state of this run. If the fingerprint is 0, the run starts from grains at random positions
    /// without contact.
    std::uint64_t start = 0;
    /// Requested standard errors of observables. Averaging may end before the shear strain `strain`
    /// once all requested standard errors are reached. If the list is empty, averaging never ends
    /// before `strain`.
    std::vector<Precision> precision = {};
    /// Physical effects on grains that act in the run, with parameter values in reduced units
    /// (grain diameter, grain mass and imposed normal stress are 1). The solver does not read this
    /// list, but receives the effects as `GrainEffects`.
    std::vector<EffectValues> effects = {};
};

/// Checks, before any computation, that a run with given physical effects on grains can be
/// simulated.
/// @throws std::invalid_argument if a parameter is out of range; the message names the parameter
void check_run_parameters(const RunParameters& parameters, const GrainEffects& effects);

}  // namespace pendular::dem
