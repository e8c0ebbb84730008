#include "workflow/rivals.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "analysis/diagnosis/ranking.h"
#include "sim/catalogue/written_effect.h"
#include "workflow/refitted_rival.h"

namespace pendular {
namespace {

std::string name_of(const Explanation& explanation, const StudyModels& models) {
    std::string name;
    for (const std::size_t k : explanation.chosen) {
        name += (name.empty() ? "" : " + ") + models.candidates()[k].name;
    }
    return name.empty() ? present_model : name;
}

/// Effects of a proposal with the models that contain them: a predictor with the effects points to
/// both.
struct Owner {
    Owner(const StudyModels& models, std::vector<Effect> more)
        : effects(std::move(more)), space(models.offering(effects)) {
        EffectSet chosen;
        for (std::size_t k = 0; k < effects.size(); ++k) {
            chosen.push_back(models.candidates().size() + k);
        }
        predictor = space.predictor(chosen);
    }
    std::vector<Effect> effects;
    StudyModels space;
    std::shared_ptr<const Predictor> predictor;
};

std::shared_ptr<const Predictor> predictor_with(const StudyModels& models,
                                                std::vector<Effect> effects) {
    const auto owner = std::make_shared<const Owner>(models, std::move(effects));
    return {owner, owner->predictor.get()};
}

Rival model_with(const StudyDiagnosis& d, const Proposal& proposal, std::size_t number) {
    std::vector<Effect> effects;
    std::string name;
    for (const FittedShape& each : proposal.shapes) {
        effects.push_back(effect_from(each.effect));
        name += (name.empty() ? "" : " + ") + each.effect.name;
    }
    const Fit& fit = proposal.explanation.fit;
    return {fmt::format("proposal {}: {}", number, name),
            predictor_with(*d.models, std::move(effects)), fit.parameters, fit.covariance,
            proposal.explanation.chi2};
}

/// Refitted model with a change that looks like the first proposal.
Rival model_with(const StudyDiagnosis& d, const FittedShape& fitted) {
    const std::string name = fitted.shape.name();
    const Eigen::VectorXd& known = d.diagnosis.fit.parameters;
    Eigen::VectorXd start(known.size() + 1);
    start << known, fitted.change;
    return refit_rival(d, name,
                       predictor_with(*d.models, {effect_from(fitted.shape.written(name))}), start);
}

}  // namespace

std::vector<Rival> proposal_rivals(const StudyDiagnosis& d) {
    std::vector<Rival> rivals;
    if (d.proposals.empty()) return rivals;
    std::vector<Rival> models;
    const auto of_sensor = [](const FittedShape& each) { return each.shape.quantity.of_sensor(); };
    for (std::size_t k = 0; k < d.proposals.size(); ++k) {
        if (std::ranges::any_of(d.proposals[k].shapes, of_sensor)) continue;
        models.push_back(model_with(d, d.proposals[k], k + 1));
    }
    for (const FittedShape& each : d.proposals.front().alike) {
        if (of_sensor(each)) continue;
        try {
            models.push_back(model_with(d, each));
        } catch (const std::domain_error&) {
            // The readings are impossible with this change.
        }
    }
    if (models.empty()) return rivals;
    const auto criterion = [](const Rival& each) {
        return akaike(each.chi2, each.parameters.size());
    };
    const double least = criterion(*std::ranges::min_element(models, {}, criterion));
    for (Rival& each : models) {
        if (criterion(each) < least + ruled_out) rivals.push_back(std::move(each));
    }
    return rivals;
}

std::vector<Rival> rivals_of(const StudyDiagnosis& study_diagnosis) {
    const Diagnosis& diagnosis = study_diagnosis.diagnosis;
    const StudyModels& models = *study_diagnosis.models;
    std::vector<Rival> rivals;
    for (const Explanation& each : diagnosis.confidence_set) {
        if (!each.suspect) {
            rivals.push_back({name_of(each, models), models.predictor(each.chosen),
                              each.fit.parameters, each.fit.covariance, each.chi2});
        }
    }
    if (diagnosis.leaders) {
        const Explanation& model = diagnosis.leaders->model;
        rivals.push_back({name_of(model, models), models.predictor(model.chosen),
                          model.fit.parameters, model.fit.covariance, model.chi2});
    }
    if (rivals.empty()) rivals = proposal_rivals(study_diagnosis);
    if (rivals.empty()) {
        rivals.push_back({present_model, models.predictor({}), diagnosis.fit.parameters,
                          diagnosis.fit.covariance, diagnosis.chi2});
    }
    if (rivals.size() == 1) {
        for (const RivalModel& rival : study_diagnosis.rivals) {
            rivals.push_back(rival.fitted);
        }
    }
    return rivals;
}

}  // namespace pendular
