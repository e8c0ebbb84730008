#include "calib/model/assemble_model.h"

#include <algorithm>
#include <utility>

#include "calib/model/closure_model.h"
#include "calib/model/mohr_coulomb.h"

namespace pendular {
namespace {

using closures::Level;

/// Model of the flow on a level of the ladder of closures.
std::shared_ptr<const FlowPredictor> flow_on(Level level, const Study& study,
                                             std::shared_ptr<const EmulatedSimulation> simulation) {
    switch (level) {
        case Level::mohr_coulomb:
            return std::make_shared<MohrCoulombModel>(std::move(simulation), study);
        case Level::simulation:
            return simulation;
        default:
            return std::make_shared<ClosureModel>(std::move(simulation), study, level);
    }
}

}  // namespace

std::shared_ptr<const EffectModel> assemble_model(
    const Study& study, std::shared_ptr<const EmulatedSimulation> simulation,
    const std::vector<const Effect*>& effects) {
    return std::make_shared<EffectModel>(
        flow_on(level_with(study, effects), study, std::move(simulation)), study, effects);
}

Level level_with(const Study& study, const std::vector<const Effect*>& effects) {
    Level level = closures::level_of_base(study.model.base);
    for (const Effect* effect : effects) {
        level = std::max(level, effect->level().value_or(level));
    }
    return level;
}

}  // namespace pendular
