#include "workflow/rivals.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

#include "analysis/diagnosis/ranking.h"
#include "sim/catalogue/written_effect.h"

namespace pendular {
namespace {

std::string name_of(const FittedModel& model) {
    return model.effects.empty() ? present_model
                                 : fmt::format("{}", fmt::join(model.effects, " + "));
}

/// Effects of a proposal with the models that contain them: a predictor with the effects points to
/// both.
struct Owner {
    Owner(const StudyModelSpace& models, std::vector<Effect> more)
        : effects(std::move(more)), space(models.offering(effects)) {
        EffectSet chosen;
        for (std::size_t k = 0; k < effects.size(); ++k) {
            chosen.push_back(models.candidates().size() + k);
        }
        predictor = space.predictor(chosen);
    }
    std::vector<Effect> effects;
    StudyModelSpace space;
    std::shared_ptr<const Predictor> predictor;
};

std::shared_ptr<const Predictor> predictor_with(const StudyModelSpace& models,
                                                std::vector<Effect> effects) {
    const auto owner = std::make_shared<const Owner>(models, std::move(effects));
    return {owner, owner->predictor.get()};
}

FittedModel model_with(const StudyDiagnosis& d, const Proposal& proposal, std::size_t number) {
    FittedModel rival = proposal.model;
    std::vector<Effect> effects;
    rival.effects.clear();
    for (const FittedShape& each : proposal.shapes) {
        effects.push_back(effect_from(each.effect));
        rival.effects.push_back(each.effect.name);
    }
    rival.name = fmt::format("proposal {}: {}", number, name_of(rival));
    rival.predictor = predictor_with(*d.models, std::move(effects));
    return rival;
}

/// Fits a rival model to the readings and direct measurements of a diagnosis.
/// @param start starting values of the parameters; empty: Parameter::start
/// @throws std::domain_error if the readings are impossible with the model
FittedModel refitted(const StudyDiagnosis& d, FittedModel rival,
                     const std::optional<Eigen::VectorXd>& start = {}) {
    // Rivals are ranked by differences of chi2 of several units (ranking.h): chi2 to a part in 1e8
    // is more than enough.
    constexpr FitEffort quick{
        .most_steps = 50, .tolerance = 1e-8, .settled = 1e-4, .elsewhere = false};
    const ModelOfReadings model(rival.predictor, conditions_of(d.readings), d.models->direct());
    rival.fit = fit(model, d.evidence.measured, start ? *start : start_of(model), quick);
    return rival;
}

/// Refitted model with a change that looks like the first proposal.
FittedModel model_with(const StudyDiagnosis& d, const FittedShape& fitted) {
    const std::string name = fitted.shape.name();
    const Eigen::VectorXd& known = d.diagnosis.base.fit.parameters;
    Eigen::VectorXd start(known.size() + 1);
    start << known, fitted.change;
    return refitted(
        d,
        {.name = name,
         .effects = {name},
         .predictor = predictor_with(*d.models, {effect_from(fitted.shape.written(name))})},
        start);
}

/// Refitted model with the effects `added` in place of a listed one.
FittedModel model_with(const StudyDiagnosis& d, const std::vector<std::string>& added,
                       const std::string& removed) {
    return refitted(d, {.name = fmt::format("{} in place of {}", fmt::join(added, " + "), removed),
                        .effects = added,
                        .in_place_of = removed,
                        .predictor = d.models->exchanged(removed, added)});
}

/// A model of a diagnosis as a rival: with its name and its predictor.
FittedModel as_rival(FittedModel model, const StudyModelSpace& models) {
    model.name = name_of(model);
    model.predictor = models.predictor(model.chosen);
    return model;
}

bool includes(const std::vector<std::string>& effects, const std::string& effect) {
    return std::ranges::find(effects, effect) != effects.end();
}

}  // namespace

std::vector<FittedModel> proposal_rivals(const StudyDiagnosis& d) {
    std::vector<FittedModel> models;
    if (d.proposals.empty()) return models;
    // A change of what a sensor shows is settled by a check of the sensor; no reading of the beads
    // tells it from a change of the beads.
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
    if (models.empty()) return models;
    const auto criterion = [](const FittedModel& each) { return akaike(each); };
    const double least = criterion(*std::ranges::min_element(models, {}, criterion));
    std::erase_if(models,
                  [&](const FittedModel& each) { return !(criterion(each) < least + ruled_out); });
    return models;
}

std::vector<FittedModel> rivals_of(const StudyDiagnosis& d) {
    const Diagnosis& diagnosis = d.diagnosis;
    std::vector<FittedModel> rivals;
    for (const FittedModel& each : diagnosis.confidence_set) {
        if (!each.suspect) rivals.push_back(as_rival(each, *d.models));
    }
    if (diagnosis.leaders) rivals.push_back(as_rival(diagnosis.leaders->model, *d.models));
    // Where no model is named, proposals are told apart; where there are none, the errors of the
    // study's model are reduced. A single model competes with the rivals of effects added earlier.
    if (rivals.empty()) rivals = proposal_rivals(d);
    if (rivals.empty()) rivals.push_back(as_rival(diagnosis.base, *d.models));
    if (rivals.size() == 1) rivals.insert(rivals.end(), d.rivals.begin(), d.rivals.end());
    return rivals;
}

std::vector<FittedModel> rivals_not_ruled_out(const StudyDiagnosis& d, const ResolvedStudy& study,
                                              const Ladder& ladder) {
    const auto listed = names_of(study.study().model.effects);
    const double limit = akaike(d.diagnosis.base) + ruled_out;
    std::vector<FittedModel> alive;
    std::set<std::pair<std::string, std::vector<std::string>>> seen;
    for (const LadderStep& step : ladder) {
        for (std::vector<std::string> rival : step.rivals) {
            std::erase_if(rival, [&](const std::string& name) { return includes(listed, name); });
            if (!includes(listed, step.effect) || rival.empty() ||
                !seen.emplace(step.effect, rival).second) {
                continue;
            }
            try {
                FittedModel model = model_with(d, rival, step.effect);
                if (akaike(model) < limit) alive.push_back(std::move(model));
            } catch (const std::invalid_argument&) {
                // The effect no longer exists or no earlier run has it.
            } catch (const std::domain_error&) {
                // The readings are impossible with this effect.
            }
        }
    }
    return alive;
}

EffectNames rivals_among(const EffectNames& sets, const std::string& effect) {
    EffectNames without;
    std::ranges::copy_if(sets, std::back_inserter(without),
                         [&](const auto& set) { return !includes(set, effect); });
    return without.size() < sets.size() ? without : EffectNames{};
}

EffectNames explaining_sets(const StudyDiagnosis& d) {
    EffectNames sets;
    for (const FittedModel& each : d.diagnosis.confidence_set) {
        if (!each.suspect) sets.push_back(each.effects);
    }
    return sets;
}

std::vector<std::string> names_of(const std::vector<ListedEffect>& effects) {
    std::vector<std::string> names;
    for (const ListedEffect& effect : effects) {
        names.push_back(effect.name);
    }
    return names;
}

}  // namespace pendular
