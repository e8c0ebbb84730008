#pragma once

#include <string>
#include <vector>

#include "data/grains.h"
#include "sim/catalogue/effect.h"
#include "sim/dem/run.h"

namespace pendular {

/// Grains, liquid and normal stress of a single run, with which values of the run are converted
/// between SI units and reduced units (grain diameter, grain mass and normal stress are 1).
struct RunScale {
    GrainProperties grains{.diameter = 500e-6, .density = 1050};
    Liquid liquid{.surface_tension = 20.6e-3};
    /// Normal stress on the grains [Pa]. For a wet run, the function `of` computes the normal
    /// stress from the reduced pressure.
    double normal_stress = 1000;

    /// Returns the grains, the liquid and the normal stress with which values of the run `run` are
    /// converted between SI units and reduced units. The normal stress of a wet run follows from
    /// its reduced pressure P*: s22 = P* F0/a^2 [Pa], with pull-off force F0 and grain diameter a.
    /// The normal stress of a dry run is `normal_stress`.
    RunScale of(const dem::RunParameters& run) const;
};

/// Returns the reason why a physical effect cannot act on a single simulation, as text for a
/// message to the user; empty if the effect can act. Effects on the instrument, on a closure
/// (formula for the strength of wet grains) or on the predicted flow cannot act on a simulation.
std::string why_not_in_run(const Effect& effect);

/// Whether a physical effect has a parameter with a unit other than 1 and rad. The value of such a
/// parameter can be converted to reduced units only if grains, liquid and normal stress are known
/// (`RunScale`).
bool needs_scale(const Effect& effect);

/// Applies physical effects to the parameters of a simulation run and returns the changed
/// parameters. Effects of type `ChangeCondition` change the friction coefficient and the reduced
/// pressure, or remove the liquid from the run. Effects on grains are added to `run.effects` in
/// reduced units.
/// @param effects effects with parameter values in SI units
/// @param scale grains, liquid and normal stress for the conversion from SI units to reduced units
///         (grain diameter, grain mass and normal stress are 1)
/// @throws std::invalid_argument for an effect that cannot act on a single run, an effect on wet
///         grains in a dry run, and an effect on dry grains in a wet run
dem::RunParameters changed_run(dem::RunParameters run, const std::vector<ActiveEffect>& effects,
                               const RunScale& scale);

}  // namespace pendular
