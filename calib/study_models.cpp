#include "calib/study_models.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "data/input_error.h"
#include "sim/closures/terms.h"

namespace pendular {

Study StudyModels::with_all_effects(Study study) {
    study.model.effects.clear();
    const EffectCatalogue catalogue(study);
    for (const Effect& effect : catalogue.all()) {
        study.model.effects.push_back({effect.name, {}});
    }
    return study;
}

StudyModels::StudyModels(const Study& study, std::vector<Condition> conditions,
                         const Fidelity& fidelity, KnownRuns known)
    : study_(study),
      conditions_(std::move(conditions)),
      catalogue_(study),
      direct_(direct_measurements(study, catalogue_)),
      listed_(catalogue_.active(study)) {
    known.orders_more = false;
    simulation_ = std::make_unique<EmulatedSimulation>(study, conditions_, fidelity, 1, Workers{},
                                                       std::move(known));
    known_range_ = std::make_unique<KnownRange>(simulation_->emulator());
    for (std::size_t k = 0; k < listed_.size(); ++k) {
        if (!told(*listed_[k])) {
            throw InputError(study.model.effects[k].position,
                             fmt::format("'effects': no known run has {} alone, so that the "
                                         "emulator cannot tell what it does; 'pendular campaign' "
                                         "makes such runs",
                                         listed_[k]->name));
        }
    }
    for (const StatedDirect& stated : study.direct) {
        if (!told(catalogue_.find(stated.effect))) {
            throw InputError(stated.effect_position,
                             fmt::format("'effect': no known run has {} alone, so that the "
                                         "emulator cannot tell what it does; 'pendular campaign' "
                                         "makes such runs, or leave this entry out",
                                         stated.effect));
        }
    }
    for (const Effect& effect : catalogue_.all()) {
        if (std::ranges::find(listed_, &effect) == listed_.end()) {
            add_candidate(effect);
        }
    }
}

std::vector<std::string> StudyModels::why_unsupported(double friction) const {
    std::vector<std::string> texts;
    for (const Condition& condition : conditions_) {
        const std::string text = why_unsupported(friction, condition);
        if (!text.empty() && std::ranges::find(texts, text) == texts.end()) {
            texts.push_back(text);
        }
    }
    return texts;
}

std::string StudyModels::why_unsupported(double friction, const Condition& condition) const {
    return known_range_->why_unsupported(simulation_->state_of(friction, condition));
}

bool StudyModels::told(const Effect& effect) const {
    return !effect.of_grains() ||
           std::ranges::any_of(simulation_->runs(), [&](const dem::RunResult& run) {
               const auto& effects = run.parameters.effects;
               return effects.size() == 1 && effects[0].effect == effect.name;
           });
}

void StudyModels::add_candidate(const Effect& effect) {
    if (const auto why = why_not(effect, study_)) {
        left_aside_.push_back({effect.name, *why});
    } else if (!told(effect)) {
        left_aside_.push_back(
            {effect.name, "no known run has it alone; 'pendular campaign' makes such runs", true});
    } else {
        Candidate candidate{effect.name, effect.parameters};
        // Where it is on in any case, what may be wrong is the value that the study gives.
        candidate.parameters.front().neutral = unlisted_value(effect, study_);
        offered_.push_back(&effect);
        candidates_.push_back(std::move(candidate));
    }
}

FlowModel& StudyModels::inside(const std::vector<const Effect*>& effects) const {
    if (study_.model.base != "rumpf") {
        return *simulation_;
    }
    const closures::Terms terms = terms_of(effects);
    auto& closure = closures_[terms.capillary_shear_stress];
    if (!closure) {
        closure = std::make_unique<RumpfModel>(*simulation_, study_, terms);
    }
    return *closure;
}

const EffectModel& StudyModels::with(const Choice& chosen) const {
    auto& model = models_[chosen];
    if (!model) {
        std::vector<const Effect*> effects = listed_;
        for (const std::size_t k : chosen) {
            effects.push_back(offered_.at(k));
        }
        model = std::make_unique<EffectModel>(inside(effects), study_, effects);
        model->predict_for(conditions_);
        model->predict_direct(direct_);
    }
    return *model;
}

ModelSpace::ChangeErrors StudyModels::change_errors(const Choice& chosen,
                                                    const Eigen::VectorXd& parameters,
                                                    std::size_t added, double value) const {
    if (std::holds_alternative<ChangeClosure>(offered_[added]->change)) {
        return {};  // of the terms of a closure, which are known far better than what they add to
    }
    Choice more = chosen;
    more.push_back(added);
    Eigen::VectorXd with_it = parameters;
    if (!candidates_[added].is_switch()) {
        with_it.conservativeResize(parameters.size() + 1);
        with_it(parameters.size()) = value;
    }
    return with(more).change_errors(with_it, with(chosen), parameters);
}

}  // namespace pendular
