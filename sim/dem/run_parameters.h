#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "data/effect_parameter.h"
#include "sim/dem/wetting.h"

namespace pendular::dem {

/// Quantity that a run averages over time, such as the stress ratio: all those of the table
/// data/quantities/observables.def. Observables of bridges are zero in runs with dry grains.
enum class Observable {
#define OBSERVABLE(name, ...) name,
#include "data/quantities/observables.def"
};

/// Names in JSON and in files of runs, in the order of `Observable`.
constexpr std::array observable_names = std::to_array<std::string_view>({
#define OBSERVABLE(name, ...) #name,
#include "data/quantities/observables.def"
});
constexpr std::size_t observable_count = observable_names.size();

/// Whether an observable is a property of bridges.
bool needs_bridges(Observable which);

/// Returns the observable of a given name.
/// @throws std::invalid_argument for an unknown name; the message lists all names
Observable observable_named(std::string_view name);

class GrainEffects;

/// Largest inertial number that can be simulated [1]. In faster flows, the sample is too dilute for
/// the servo that adjusts the height of the cell to keep the normal stress.
constexpr double largest_inertial_number = 0.5;

/// Largest allowed standard error of one observable, in its unit. A run may end early once all
/// requested standard errors are reached.
struct Precision {
    Observable which = Observable::stress_ratio;
    double standard_error = 0;
};
/// Returns a precision written as "stress_ratio=0.003".
/// @throws std::invalid_argument if the text has another form or the observable is unknown
Precision precision_named(std::string_view text);

/// Smallest shear strain over which a run must average before its standard errors are reliable [1].
/// Solid fractions decorrelate over a strain of 0.1 to 0.2.
constexpr double shortest_precise_strain = 2;

/// Parameters [1] that determine one run of steady shear.
struct RunParameters {
    double friction = 0.09;
    double inertial_number = 1e-3;
    double stiffness_number = 1000;
    double poisson_ratio = 0.3;
    double damping = 0.98;           ///< of the normal motion in contacts, over critical damping
    std::optional<Wetting> wetting;  ///< empty for dry grains
    int grains = 2000;
    double strain = 10;  ///< over which the run is averaged, without transient
    std::uint64_t seed = 1;
    /// Fingerprint (function `fingerprint`) of the run whose final state is the initial state; 0:
    /// grains at random positions without contact.
    std::uint64_t start = 0;
    /// Standard errors at which averaging may end before `strain`; empty: never.
    std::vector<Precision> precision = {};
    /// Effects on grains with values in reduced units (grain diameter, grain mass and imposed
    /// normal stress are 1). The solver does not read this list, but receives the effects as
    /// `GrainEffects`.
    std::vector<EffectValues> effects = {};
};

/// Checks, before any computation, that a run with given effects can be simulated.
/// @throws std::invalid_argument if a parameter is out of range; the message names the parameter
void check_run_parameters(const RunParameters& parameters, const GrainEffects& effects);

}  // namespace pendular::dem
