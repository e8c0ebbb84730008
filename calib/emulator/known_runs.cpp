#include "calib/emulator/known_runs.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "calib/emulator/emulated_observables.h"

namespace pendular {

std::vector<dem::RunResult> runs_serving(const Study& study, const Fidelity& fidelity,
                                         const std::vector<dem::RunResult>& runs) {
    // Changes the ratio of tangential to normal stiffness by less than a tenth.
    constexpr double largest_poisson_difference = 0.1;
    // As many as all runs of the atlas have. Smaller samples feel their periodic images more.
    constexpr int enough_grains = 1000;
    std::vector<dem::RunResult> result;
    std::ranges::copy_if(runs, std::back_inserter(result), [&](const dem::RunResult& run) {
        const auto& p = run.parameters;
        return emulated::usable(run) && p.grains >= std::min(fidelity.grains, enough_grains) &&
               std::abs(p.poisson_ratio - study.grains.poisson_ratio) <=
                   largest_poisson_difference &&
               (!p.wetting || p.wetting->bridge_force == study.model.bridge_force) &&
               std::ranges::all_of(p.effects, [&](const EffectValues& effect) {
                   return std::ranges::find(study.model.effects, effect.effect,
                                            &ListedEffect::name) != study.model.effects.end();
               });
    });
    return result;
}

}  // namespace pendular
