#include "calib/model/assemble_model.h"

#include <utility>
#include <variant>

#include "calib/model/rumpf.h"

namespace pendular {

std::shared_ptr<const EffectModel> assemble_model(
    const Study& study, std::shared_ptr<const EmulatedSimulation> simulation,
    const std::vector<const Effect*>& effects) {
    std::shared_ptr<const FlowPredictor> base = simulation;
    if (study.model.base == "rumpf") {
        base = std::make_shared<RumpfModel>(std::move(simulation), study, terms_of(effects));
    }
    return std::make_shared<EffectModel>(std::move(base), study, effects);
}

closures::Terms terms_of(const std::vector<const Effect*>& effects) {
    closures::Terms terms;
    for (const Effect* effect : effects) {
        if (const auto* change = std::get_if<ChangeClosure>(&effect->change)) {
            terms.*(change->term) = true;
        }
    }
    return terms;
}

}  // namespace pendular
