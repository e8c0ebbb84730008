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

/// Fastest shear that is still a dense flow, to which the height servo can hold the stress.
constexpr double largest_inertial_number = 0.5;

/// Standard error of an observable at which averaging may stop.
struct Precision {
    Observable which = Observable::stress_ratio;
    double standard_error = 0;
};
/// Precision that a text such as "stress_ratio=0.003" states.
/// @throws std::invalid_argument for any other text and for an unknown observable
Precision precision_named(std::string_view text);

/// Shortest averaged strain whose standard errors can be relied on [1].
constexpr double shortest_precise_strain = 2;

/// Everything that determines one run of steady shear, reduced units.
struct RunParameters {
    double friction = 0.09;          ///< mu
    double inertial_number = 1e-3;   ///< I
    double stiffness_number = 1000;  ///< kappa
    double poisson_ratio = 0.3;      ///< nu
    double damping = 0.98;           ///< zeta, fraction of critical
    std::optional<Wetting> wetting;  ///< liquid bridges; none: dry
    int grains = 2000;
    double strain = 10;  ///< averaged strain, after the transient
    std::uint64_t seed = 1;
    /// Fingerprint of the run from whose final state this one starts; 0: a random gas.
    std::uint64_t start = 0;
    /// Standard errors at which averaging may stop before `strain` is reached; none: it goes on.
    std::vector<Precision> precision = {};
    /// Effects on grains that are on, by name, their values in the units of the run: a record,
    /// which the solver leaves to those who resolve names.
    std::vector<EffectValues> effects = {};
};

/// Refuses what cannot be simulated with these effects, before any work.
/// @throws std::invalid_argument for parameters out of range, naming the parameter
void check_run_parameters(const RunParameters& parameters, const GrainEffects& effects);

}  // namespace pendular::dem
