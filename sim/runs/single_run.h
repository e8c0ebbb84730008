#pragma once

#include <string>
#include <vector>

#include "data/grains.h"
#include "sim/catalogue/effect.h"
#include "sim/dem/run.h"

namespace pendular {

/// Grains, liquid and normal stress by which values of a single run are converted between SI units
/// and reduced units, in which grain diameter, grain mass and normal stress are 1.
struct RunScale {
    GrainProperties grains{.diameter = 500e-6, .density = 1050};
    Liquid liquid{.surface_tension = 20.6e-3};
    double normal_stress = 1000;  ///< on the grains of a dry run [Pa]; wet: see `of`

    /// Returns the scale of a run. The normal stress of a wet run follows from its reduced pressure
    /// P*: s22 = P* F0/a^2 [Pa], with pull-off force F0 and grain diameter a.
    RunScale of(const dem::RunParameters& run) const;
};

/// Returns the reason why an effect cannot act on a single simulation, as text for a message; empty
/// if it can. Effects on the instrument, on a closure or on the predicted flow cannot.
std::string why_not_in_run(const Effect& effect);

/// Whether an effect has a parameter with a unit other than 1 and rad, which can be converted to
/// reduced units only with a `RunScale`.
bool needs_scale(const Effect& effect);

/// Returns the parameters of a run after effects: those of type `ChangeCondition` change the
/// friction coefficient and the reduced pressure, or remove the liquid; effects on grains are added
/// to `run.effects` in reduced units.
/// @param effects with values in SI units
/// @throws std::invalid_argument for an effect that cannot act on a single run, an effect on wet
///         grains in a dry run, and an effect on dry grains in a wet run
dem::RunParameters changed_run(dem::RunParameters run, const std::vector<ActiveEffect>& effects,
                               const RunScale& scale);

}  // namespace pendular
