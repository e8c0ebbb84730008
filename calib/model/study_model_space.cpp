#include "calib/model/study_model_space.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "calib/model/closure_model.h"
#include "calib/model/mohr_coulomb.h"
#include "data/input_error.h"

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

/// Group of an effect in tables of candidates: where it acts.
std::string group_of(const Effect& effect) {
    if (effect.of_instrument()) return "instrument";
    if (effect.of_grains()) return "grains";
    if (effect.of_condition() || effect.of_closure()) return "beads and liquid";
    return "formulas of the study";
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

Study StudyModelSpace::with_all_effects(const ResolvedStudy& study) {
    Study all = study;
    all.model.effects.clear();
    for (const Effect& effect : study.catalogue().all()) {
        all.model.effects.push_back({effect.name, {}});
    }
    return all;
}

StudyModelSpace::StudyModelSpace(const ResolvedStudy& study, std::vector<Condition> conditions,
                                 const Fidelity& fidelity, KnownRuns known)
    : study_(study), conditions_(std::move(conditions)) {
    simulation_ = std::make_shared<EmulatedSimulation>(
        study, fidelity, Emulator(known.runs, std::move(known.hyperparameters)));
    known_range_ = std::make_shared<KnownRange>(simulation_->emulator());
    const std::vector<const Effect*>& listed = study_.effects();
    for (std::size_t k = 0; k < listed.size(); ++k) {
        if (!has_runs(*listed[k])) {
            throw InputError(study_.study().model.effects[k].position,
                             fmt::format("'effects': no simulation in atlas and store has {} as "
                                         "its only effect, so that the emulator cannot predict it; "
                                         "make such simulations with 'pendular campaign'",
                                         listed[k]->name));
        }
    }
    for (const StatedDirect& stated : study_.study().direct) {
        if (!has_runs(study_.catalogue().find(stated.effect))) {
            throw InputError(
                stated.effect_position,
                fmt::format("'effect': no simulation in atlas and store has {} as its only effect, "
                            "so that the emulator cannot predict it; make such simulations with "
                            "'pendular campaign', or leave this entry out",
                            stated.effect));
        }
    }
    for (const Effect& effect : study_.catalogue().all()) {
        if (std::ranges::find(listed, &effect) == listed.end()) {
            add_candidate(effect);
        }
    }
}

std::vector<std::string> StudyModelSpace::why_unsupported(double friction) const {
    std::vector<std::string> texts;
    for (const Condition& condition : conditions_) {
        const std::string text = why_unsupported(friction, condition);
        if (!text.empty() && std::ranges::find(texts, text) == texts.end()) {
            texts.push_back(text);
        }
    }
    return texts;
}

std::string StudyModelSpace::why_unsupported(double friction, const Condition& condition) const {
    return known_range_->why_unsupported(simulation_->flow_state_at(friction, condition));
}

bool StudyModelSpace::has_runs(const Effect& effect) const {
    return !effect.of_grains() || simulation_->emulator().knows(effect.name);
}

bool StudyModelSpace::bed_may_be_uneven() const {
    const auto& cell = study_.study().cell;
    // Between walls without friction, a gap creeps for another reason.
    if (cell && cell->wall_friction) return *cell->wall_friction > 0;
    return std::ranges::any_of(conditions_, [](const Condition& c) { return c.gap_creep != 0; });
}

void StudyModelSpace::add_candidate(const Effect& effect) {
    if (effect.of_uneven_shear && !bed_may_be_uneven()) return;
    if (const auto why = why_not(effect, study_)) {
        untestable_effects_.push_back({effect.name, *why});
    } else if (!has_runs(effect)) {
        untestable_effects_.push_back(
            {effect.name,
             "no simulation in atlas and store has it as its only effect; "
             "'pendular campaign' makes such simulations",
             true});
    } else {
        Candidate candidate{effect.name, effect.parameters, group_of(effect)};
        std::erase_if(candidate.parameters, &EffectParameter::only_simulated);
        // An effect that the liquid switches on is neutral at the value that the liquid gives.
        candidate.parameters.front().neutral = effect.unlisted_value(study_.study().liquid);
        if (effect.of_closure()) candidate.level = static_cast<int>(*effect.level());
        offered_.push_back(&effect);
        candidates_.push_back(std::move(candidate));
    }
}

std::shared_ptr<const EffectModel> StudyModelSpace::predictor(const EffectSet& chosen) const {
    std::vector<const Effect*> effects = study_.effects();
    for (const std::size_t k : chosen) {
        effects.push_back(offered_.at(k));
    }
    return assemble_model(study_, simulation_, effects);
}

StudyModelSpace StudyModelSpace::offering(const std::vector<Effect>& more) const {
    StudyModelSpace models = *this;
    for (const Effect& effect : more) {
        models.add_candidate(effect);
    }
    return models;
}

StudyModelSpace StudyModelSpace::with_discrepancy(const std::array<double, 2>& discrepancy) const {
    StudyModelSpace models = *this;
    Study inexact = study_;
    inexact.model.discrepancy = discrepancy;
    models.study_ = study_.changed_to(std::move(inexact));
    return models;
}

std::shared_ptr<const EffectModel> StudyModelSpace::with_only(
    const std::vector<std::string>& names) const {
    std::vector<const Effect*> effects;
    for (const std::string& name : names) {
        const Effect& effect = study_.catalogue().find(name);
        if (!has_runs(effect)) {
            throw std::invalid_argument("no simulation in atlas and store has " + name + " alone");
        }
        effects.push_back(&effect);
    }
    return assemble_model(study_, simulation_, effects);
}

std::shared_ptr<const EffectModel> StudyModelSpace::exchanged(
    const std::string& removed, const std::vector<std::string>& added) const {
    std::vector<std::string> names;
    for (const Effect* effect : study_.effects()) {
        if (effect->name != removed) names.push_back(effect->name);
    }
    names.insert(names.end(), added.begin(), added.end());
    return with_only(names);
}

std::shared_ptr<const Model> StudyModelSpace::with(const EffectSet& chosen) const {
    return std::make_shared<ModelOfReadings>(predictor(chosen), conditions_, direct());
}

int StudyModelSpace::internally_fitted_values() const {
    const Study& study = study_.study();
    return fitted_cohesions(study.model, study.grains, study.liquid);
}

ModelSpace::ChangeErrors StudyModelSpace::change_errors(const EffectSet& chosen,
                                                        const Eigen::VectorXd& parameters,
                                                        std::size_t added,
                                                        const Eigen::VectorXd& values) const {
    if (offered_[added]->of_closure()) {
        return {};  // a closure has no known error
    }
    EffectSet more = chosen;
    more.push_back(added);
    Eigen::VectorXd with_it(parameters.size() + values.size());
    with_it << parameters, values;
    ChangeErrors errors =
        predictor(more)->change_errors(with_it, *predictor(chosen), parameters, conditions_);
    // A direct measurement has no simulation error.
    widen(errors.change, std::ssize(direct()));
    widen(errors.with_without, std::ssize(direct()));
    return errors;
}

}  // namespace pendular
