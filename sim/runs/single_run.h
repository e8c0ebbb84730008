#pragma once

#include <string>
#include <vector>

#include "data/grains.h"
#include "sim/catalogue/effect.h"
#include "sim/dem/run.h"

namespace pendular {

/// Grains, liquid and stress that a single run in reduced units stands for, where an effect has
/// parameters in SI units.
struct RunScale {
    GrainProperties grains{.diameter = 500e-6, .density = 1050};
    Liquid liquid{.surface_tension = 20.6e-3};
    double normal_stress = 1000;  ///< [Pa] of dry grains

    /// Scale with the normal stress [Pa] of a wet run: s22 = P* F0/a^2.
    RunScale of(const dem::RunParameters& run) const;
};

/// Why a single run cannot have an effect, for messages; empty where it can.
std::string why_no_run_has(const Effect& effect);

/// Whether what an effect does to a run depends on its scale.
bool needs_scale(const Effect& effect);

/// A run as effects on its grains and its liquid make it, at its scale: those of type
/// ChangeCondition change friction and reduced pressure, those on grains are brought to its units.
/// @throws std::invalid_argument for an effect that a single run cannot have or that does not touch
///         its grains, dry or wet as they are
dem::RunParameters changed_run(dem::RunParameters run, const std::vector<ActiveEffect>& effects,
                               const RunScale& scale);

}  // namespace pendular
