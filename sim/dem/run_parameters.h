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

/// Largest inertial number at which the flow is dense enough for the height servo to hold the
/// normal stress [1].
constexpr double largest_inertial_number = 0.5;

/// Standard error, in the observable's unit, of one observable's time average, at which a run may
/// stop averaging.
struct Precision {
    Observable which = Observable::stress_ratio;
    double standard_error = 0;
};
/// Parses an observable's name and the standard error at which a run may stop averaging it, written
/// as "stress_ratio=0.003".
/// @throws std::invalid_argument where the text is not of this form or the observable is unknown
Precision precision_named(std::string_view text);

/// Shortest strain that a run must average over before its standard errors can be relied on [1].
constexpr double shortest_precise_strain = 2;

/// Everything that determines one run of steady shear, reduced units.
struct RunParameters {
    double friction = 0.09;          ///< intergranular friction coefficient mu
    double inertial_number = 1e-3;   ///< inertial number I
    double stiffness_number = 1000;  ///< stiffness number kappa
    double poisson_ratio = 0.3;      ///< Poisson ratio nu
    double damping = 0.98;           ///< zeta, fraction of critical damping in normal direction
    std::optional<Wetting> wetting;  ///< liquid bridges; none: dry
    int grains = 2000;
    double strain = 10;  ///< shear strain over which is averaged, after the transient
    std::uint64_t seed = 1;
    /// Fingerprint of the run whose final state is the initial state of this run; 0: start from a
    /// random gas.
    std::uint64_t start = 0;
    /// Standard errors to reach: averaging may end before `strain` once all of them are reached.
    /// Empty: averaging never ends before `strain`.
    std::vector<Precision> precision = {};
    /// Names of the effects on grains that act in the run, with parameter values in reduced units.
    /// A record only: the solver takes the effects as GrainEffects.
    std::vector<EffectValues> effects = {};
};

/// Checks, before any work, that a run can be simulated with these effects on grains.
/// @throws std::invalid_argument where a parameter is out of range, naming the parameter
void check_run_parameters(const RunParameters& parameters, const GrainEffects& effects);

}  // namespace pendular::dem
