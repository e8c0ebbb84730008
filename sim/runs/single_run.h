#pragma once

#include <string>
#include <vector>

#include "data/grains.h"
#include "sim/catalogue/effect.h"
#include "sim/dem/run.h"

namespace pendular {

/// Grains, liquid and normal stress that convert between SI units and the reduced units of a single
/// run, for effects with parameters in SI units.
struct RunScale {
    GrainProperties grains{.diameter = 500e-6, .density = 1050};
    Liquid liquid{.surface_tension = 20.6e-3};
    double normal_stress = 1000;  ///< normal stress on dry grains [Pa]

    /// Returns the grains, liquid and normal stress to convert units of this run. For a wet run the
    /// normal stress [Pa] follows from its reduced pressure, s22 = P* F0/a^2; for a dry run it is
    /// unchanged.
    RunScale of(const dem::RunParameters& run) const;
};

/// Returns the reason, as text for a message, why an effect cannot act on a single simulation run:
/// it acts on the instrument, a closure (analytical formula) or the flow. Empty where it can act.
std::string why_no_run_has(const Effect& effect);

/// Whether an effect has a parameter in a unit other than 1 and rad, so that grains, liquid and
/// normal stress (RunScale) must be known to convert its value to the reduced units of a run.
bool needs_scale(const Effect& effect);

/// Returns the parameters of a run as changed by effects, given in SI units. Effects of type
/// ChangeCondition change friction and reduced pressure; effects on grains are added to
/// `run.effects` with their values converted to the reduced units of the run. `scale`: grains,
/// liquid and normal stress of the conversion.
/// @throws std::invalid_argument for an effect that cannot act on a single run, acts on wet grains
///         where the run is dry, or acts on dry grains where the run is wet
dem::RunParameters changed_run(dem::RunParameters run, const std::vector<ActiveEffect>& effects,
                               const RunScale& scale);

}  // namespace pendular
