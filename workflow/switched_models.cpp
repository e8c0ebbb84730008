#include "workflow/switched_models.h"

#include <algorithm>
#include <bit>
#include <iterator>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "analysis/diagnosis/side_by_side.h"
#include "analysis/misfit/live_misfit.h"
#include "calib/fit/calibrate_study.h"
#include "calib/fit/inexactness.h"
#include "calib/fit/measured.h"
#include "calib/fit/nearby_fit.h"
#include "data/input_error.h"
#include "workflow/rivals.h"

namespace pendular {
namespace {

using Effects = std::vector<std::string>;

/// Part of the standard error of a reading by which the expanded predictions may be off [1].
/// Chosen: a difference that no figure shows and that no reading could reveal.
constexpr double trusted_part = 0.1;

void add_once(Effects& names, const std::string& name) {
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
}

/// Names of the candidate effects by rank: those of the verdict, of models that fit, and of the
/// refits with the largest reduction of chi2.
Effects leading(const StudyDiagnosis& d) {
    const auto& candidates = d.models->candidates();
    const Diagnosis& diagnosis = d.diagnosis;
    Effects names;
    for (const std::string& effect : diagnosis.effects) {
        const bool is_candidate =
            std::ranges::find(candidates, effect, &Candidate::name) != candidates.end();
        // An inconclusive verdict lists what the readings could not reveal, in no order of rank.
        if (is_candidate && diagnosis.verdict != Verdict::inconclusive) add_once(names, effect);
    }
    for (const FittedModel& each : diagnosis.confidence_set) {
        for (const std::size_t k : each.chosen) {
            if (k < candidates.size()) add_once(names, candidates[k].name);
        }
    }
    std::vector<const Finding*> refitted;
    for (const Finding& finding : diagnosis.scan) {
        if (finding.refitted_reduction) refitted.push_back(&finding);
    }
    std::ranges::stable_sort(refitted, std::ranges::greater(),
                             [](const Finding* f) { return *f->refitted_reduction; });
    for (const Finding* finding : refitted) {
        add_once(names, candidates[finding->candidate].name);
    }
    for (const Finding& finding : diagnosis.scan) {
        add_once(names, candidates[finding.candidate].name);
    }
    return names;
}

/// Values of a model's parameters where its fit starts: those of a fit with fewer effects, and the
/// usual start of all other parameters.
Eigen::VectorXd start_from(const Calibration& fewer, const std::vector<Parameter>& parameters) {
    Eigen::VectorXd start(static_cast<Eigen::Index>(parameters.size()));
    for (std::size_t k = 0; k < parameters.size(); ++k) {
        const auto same = std::ranges::find(fewer.parameters, parameters[k].name, &Parameter::name);
        start(static_cast<Eigen::Index>(k)) =
            same == fewer.parameters.end()
                ? parameters[k].start
                : fewer.fit.parameters(std::distance(fewer.parameters.begin(), same));
    }
    return start;
}

/// Fits the first `count` readings of a calibration.
/// @param fewer fit of the same readings with fewer effects; null: none
Fit fit_first(std::size_t count, const SwitchedModel& model, const ResolvedStudy& study,
              const Eigen::VectorXd& start, const Calibration* fewer = nullptr) {
    const auto readings = part(model.calibration.readings, 0, count);
    const ModelOfReadings of_readings(model.predictor, conditions_of(readings), study.direct());
    const Measured measured = stack(readings, study.direct());
    // The usual start may be far from the minimum, and a search nearby end at another one.
    if (!fewer) return fit(of_readings, measured, start);
    return nearby_fit(of_readings, measured, start,
                      fewer->fitted == count ? &fewer->fit.prediction.covariance : nullptr);
}

/// Fits the model of a calibration as `calibrate_study` does without new simulations: a joint fit
/// of the friction alone begins at the optimum of the dry readings.
/// @param fewer fit with fewer effects; null: none
Fit fit_as_added(const SwitchedModel& model, const ResolvedStudy& study, const Calibration* fewer) {
    const Calibration& c = model.calibration;
    Eigen::VectorXd start = start_from(fewer ? *fewer : Calibration{}, c.parameters);
    const std::size_t dry = dry_count(c.readings);
    if (c.fitted > dry && dry > 0 && c.parameters.size() == 1) {
        start = fit_first(dry, model, study, start).parameters;
    }
    return fit_first(c.fitted, model, study, start, fewer);
}

/// Rows of a response.
Response rows_of(const Response& all, const std::vector<Eigen::Index>& rows) {
    return {.at = all.at,
            .value = all.value(rows),
            .first = all.first(rows, Eigen::all),
            .second = all.second(rows, Eigen::all)};
}

std::vector<Eigen::Index> counted(Eigen::Index from, Eigen::Index to) {
    std::vector<Eigen::Index> result(static_cast<std::size_t>(to - from));
    std::iota(result.begin(), result.end(), from);
    return result;
}

/// Sets the expansions of a fitted model, at the readings and along further conditions.
void respond_at(SwitchedModel& model, const ResolvedStudy& study, const Eigen::VectorXd& errors,
                const std::vector<Condition>& along) {
    const Calibration& c = model.calibration;
    std::vector<Condition> conditions = conditions_of(c.readings);
    conditions.insert(conditions.end(), along.begin(), along.end());
    const Response all = respond(ModelOfReadings(model.predictor, conditions, study.direct()),
                                 c.fit.parameters, errors);
    const auto readings = 2 * static_cast<Eigen::Index>(c.readings.size());
    const Eigen::Index further = readings + 2 * static_cast<Eigen::Index>(along.size());
    std::vector<Eigen::Index> measured = counted(0, readings);
    std::ranges::copy(counted(further, all.value.size()), std::back_inserter(measured));
    model.response = rows_of(all, measured);
    model.along = rows_of(all, counted(readings, further));
}

/// Adds what a page needs to let a fitted model's parameters move.
void expand(SwitchedModel& model, const ResolvedStudy& study, const std::vector<Condition>& along) {
    const Calibration& c = model.calibration;
    const ModelOfReadings all(model.predictor, conditions_of(c.readings), study.direct());
    const Measured measured = stack(c.readings, study.direct());
    const Eigen::VectorXd errors = c.fit.standard_errors();
    respond_at(model, study, errors, along);
    const auto readings = 2 * static_cast<Eigen::Index>(c.readings.size());
    model.trusted =
        trusted_box(all, model.response,
                    trusted_part * measured.covariance.diagonal().head(readings).cwiseSqrt(),
                    errors, all.bounds());
    Eigen::MatrixXd simulation =
        Eigen::MatrixXd::Zero(measured.value.size(), measured.value.size());
    simulation.topLeftCorner(readings, readings) = c.prediction.covariance;
    model.chi2_form = chi2_form(measured, simulation, model.response);
    const auto fitted = part(c.readings, 0, c.fitted);
    model.without_each = without_each(stack(fitted, study.direct()), c.fit.prediction, c.fitted);
}

/// The study with exactly these effects.
/// @throws InputError for effects that the base model does not allow
ResolvedStudy study_with(const Effects& effects, const ResolvedStudy& study) {
    Study changed = study;
    changed.model.effects.clear();
    for (const std::string& name : effects) {
        changed.model.effects.push_back({name, {study.study().file.string()}});
    }
    return study.changed_to(std::move(changed));
}

/// The study with all readings fitted together where it is fitted so with one of its effects or of
/// `switches`, so that the errors of all combinations can be compared; else the study.
ResolvedStudy with_common_readings(const ResolvedStudy& study, const Effects& switches,
                                   const std::vector<Reading>& readings) {
    const bool all = std::ranges::any_of(switches, [&](const std::string& name) {
        return fitted_count(study_with({name}, study), readings) == readings.size();
    });
    return all ? fitting_all(study) : study;
}

/// Fits the study with exactly these effects, as `calibrate` does. `models`: with the discrepancy
/// that the study expects. `fewer`: fit with fewer effects; null: none.
SwitchedModel fitted_with(const Effects& effects, const ResolvedStudy& study,
                          const StudyModelSpace& models, const StudyDiagnosis& d,
                          const SessionOptions& session, const std::vector<Condition>& along,
                          const Calibration* fewer) {
    const ResolvedStudy with = study_with(effects, study);
    SwitchedModel result{.predictor = models.with_only(effects)};
    Calibration& c = result.calibration;
    c.readings = d.readings;
    c.fitted = fitted_count(with, c.readings);
    if (c.fitted == 0) c.fitted = c.readings.size();  // a study without dry readings
    c.direct = with.direct();
    c.grains = with.study().grains;
    c.liquid = with.study().liquid;
    c.model = with.study().model;
    c.written_effects = with.study().written_effects;
    c.fidelity = session.fidelity;
    c.seed = session.seed;
    c.parameters = result.predictor->parameters();
    c.fit = fit_as_added(result, with, fewer);
    if (!c.model.discrepancy_stated)
        c.fit.inexactness = likely_inexactness(stack(part(c.readings, 0, c.fitted), c.direct),
                                               c.fit.prediction, c.fit.at_bound)
                                .factor;
    c.prediction = c.fitted == c.readings.size() && c.direct.empty()
                       ? c.fit.prediction
                       : predict_readings(*result.predictor, c);
    result.comparison = compare(c);
    expand(result, with, along);
    return result;
}

/// Fit with the least chi2 of all combinations with `fewer` effects fewer; null where there is
/// none, and for single effects, which start as `calibrate_study` starts.
const Calibration* best_with_fewer(const SwitchedModels& all, std::size_t index, int fewer) {
    const SwitchedModel* best = nullptr;
    const int effects = std::popcount(index);
    if (effects < 2) return nullptr;
    for (std::size_t part = 0; part < index; ++part) {
        if ((part & index) != part || std::popcount(part) != effects - fewer) continue;
        const auto& model = all.models[part];
        if (model && (!best || model->comparison.total.chi2 < best->comparison.total.chi2)) {
            best = &*model;
        }
    }
    return best ? &best->calibration : nullptr;
}

/// Combinations of `switches` effects, by index, in groups whose fits begin near the fits of
/// earlier groups: by the number of effects. That of all effects, which takes longest, is fitted
/// beside those with one fewer.
std::vector<std::vector<std::size_t>> in_groups(std::size_t switches) {
    std::vector<std::vector<std::size_t>> groups(std::max(switches, std::size_t(1)));
    const std::size_t all = (std::size_t(1) << switches) - 1;
    groups.back().push_back(all);
    for (std::size_t index = 0; index < all; ++index) {
        groups[static_cast<std::size_t>(std::popcount(index))].push_back(index);
    }
    return groups;
}

}  // namespace

SwitchedModels switched_models(const ResolvedStudy& study, const StudyDiagnosis& diagnosis,
                               const SessionOptions& session, const SwitchOptions& options) {
    const std::size_t most = options.most;
    SwitchedModels result{.study = study};
    const Effects listed = names_of(study.study().model.effects);
    result.switches = listed;
    for (const std::string& name : leading(diagnosis)) {
        add_once(result.switches, name);
    }
    for (std::size_t k = most; k < listed.size(); ++k) {
        result.always.push_back(listed[k]);
    }
    result.switches.resize(std::min(result.switches.size(), most));
    const ResolvedStudy fitted = with_common_readings(study, result.switches, diagnosis.readings);
    const StudyModelSpace models =
        diagnosis.models->with_discrepancy(study.study().model.discrepancy);
    // Listed effects come first among the switches, so that the lowest bits stand for the study.
    result.current = (std::size_t(1) << std::min(listed.size(), most)) - 1;
    result.models.resize(std::size_t(1) << result.switches.size());
    result.why_not.resize(result.models.size());
    std::size_t finished = 0;
    const auto report = [&](std::size_t) {
        if (session.stop.stop_requested()) throw interrupted_with(session.store);
        tell(session.listener, {.kind = Event::Kind::refits,
                                .text = "combinations of effects",
                                .number = finished,
                                .total = result.models.size()});
    };
    const auto fit_one = [&](std::size_t index) {
        // All effects are fitted beside the sets with one fewer (`in_groups`), not after them.
        const int fewer = index + 1 == result.models.size() ? 2 : 1;
        Effects effects = result.always;
        for (std::size_t k = 0; k < result.switches.size(); ++k) {
            if ((index >> k) & 1) effects.push_back(result.switches[k]);
        }
        try {
            result.models[index] =
                fitted_with(effects, fitted, models, diagnosis, session, options.along,
                            best_with_fewer(result, index, fewer));
        } catch (const std::domain_error&) {
            result.why_not[index] = "the readings are impossible with these effects";
        } catch (const std::invalid_argument& error) {
            result.why_not[index] = error.what();  // no known run has an effect alone
        } catch (const InputError& error) {
            result.why_not[index] = error.what();  // effects that the base model does not allow
        }
    };
    for (const std::vector<std::size_t>& group : in_groups(result.switches.size())) {
        side_by_side(group.size(), static_cast<std::size_t>(session.threads), report,
                     [&](std::size_t k) { fit_one(group[k]); });
        finished += group.size();
    }
    return result;
}

}  // namespace pendular
