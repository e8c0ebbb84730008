#include "workflow/study_diagnosis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "analysis/misfit/compare.h"
#include "calib/fit/calibrate_study.h"
#include "calib/fit/calibration.h"
#include "calib/fit/inexactness.h"
#include "calib/fit/parameter_errors.h"
#include "data/input_error.h"
#include "data/quantities/quantity.h"
#include "data/recordings/reading_groups.h"
#include "workflow/study_input.h"

namespace pendular {
namespace {

/// Text that names the measurements which may cause an implausible value of a quantity.
std::string cause_of(const std::string& quantity) {
    if (quantity == "solid_fraction") return "the gap or the bead mass (solid fraction)";
    if (quantity == "stress_ratio") return "the torque or the normal force (stress ratio)";
    return "the " + std::string(pendular::quantity(quantity).meaning);
}

/// Parts of the measurement that are doubtful in themselves: a column that may be in a wrong unit,
/// and implausible readings that were kept.
std::vector<std::string> doubtful_parts(const std::optional<UnitMistake>& mistake,
                                        const Study& study, const Measurements& measurements) {
    std::set<std::string> parts;
    if (mistake) {
        parts.insert(fmt::format("the unit of the {} {}", mistake->column, mistake->files));
    }
    for (const Remark& doubt : measurements.with(Remark::Outcome::kept)) {
        if (study.import.keep_implausible) parts.insert(cause_of(doubt.quantity));
    }
    return {parts.begin(), parts.end()};
}

/// Whether a model with known effects explains the readings at least as well as a wrong unit, by
/// Akaike's criterion. Its chi2 is without the errors that `UnitMistake` grants the model.
bool explained_by_effects(const Diagnosis& diagnosis, const UnitMistake& mistake) {
    return std::ranges::any_of(diagnosis.fitting, [&](const FittedModel& each) {
        return each.fit.chi2 + 2.0 * static_cast<double>(each.chosen.size()) <= mistake.chi2_after;
    });
}

/// Faults inside the recordings, and how much of the misfit they may explain.
std::vector<RecordingEvidence> recordings_beside(const StudyDiagnosis& d, bool misfit,
                                                 const std::vector<Remark>& findings) {
    if (findings.empty()) return {};
    double by_effects = 0;
    for (const Finding& effect : d.diagnosis.scan)
        by_effects = std::max(by_effects, effect.test.predicted_reduction);
    // Where errors are large, chi2 may be below its degrees of freedom although an explanation
    // reduces it significantly: what the best one reduces is then the misfit to explain.
    double excess = misfit ? std::max(0.0, d.diagnosis.excess()) : 0;
    if (misfit)
        for (const FittedModel& each : d.diagnosis.tried)
            excess = std::max(excess, d.diagnosis.base.fit.chi2 - each.fit.chi2);
    return recording_evidence(findings, d.readings, d.diagnosis.residuals(d.evidence), excess,
                              by_effects);
}

/// Callback that reports the progress of work to the listener of a session, and ends the work where
/// the user stops it.
std::function<void(std::string_view, std::size_t, std::size_t)> progress_of(
    const SessionOptions& session) {
    return [&session](std::string_view what, std::size_t at, std::size_t of) {
        if (session.stop.stop_requested()) throw dem::Interrupted();
        tell(session.listener,
             {.kind = Event::Kind::refits, .text = std::string(what), .number = at, .total = of});
    };
}

/// Diagnoses a study whose models and evidence are set. Returns how well its model describes the
/// readings with the expected discrepancy, as `calibrate` and `compare` judge.
Agreement diagnose_into(StudyDiagnosis& result, const ModelSettings& model,
                        const DiagnosisOptions& options) {
    Fit as_expected;
    if (model.discrepancy_stated) {
        result.discrepancy = model.discrepancy;
        result.diagnosis = diagnose(*result.models, result.evidence, options);
        as_expected = result.diagnosis.base.fit;
    } else {
        InexactDiagnosis found =
            diagnose_inexact(*result.models, model.discrepancy, result.evidence, options);
        result.diagnosis = std::move(found.diagnosis);
        *result.models = std::move(found.models);
        result.discrepancy = found.discrepancy;
        as_expected = std::move(found.as_expected);
    }
    return agreement_of(
        result.readings, result.models->direct(), as_expected.prediction, as_expected.at_bound,
        {as_expected.chi2, result.diagnosis.dof, freedom_behind(result.readings)}, model);
}

/// Checks that the readings suffice for a diagnosis.
/// @throws InputError where all readings are at one condition, and
///         where a reading cannot be simulated
void check_readings(const std::vector<Reading>& readings, const Study& study,
                    const Fidelity& fidelity) {
    check_range(readings, study, fidelity);
    if (replicate_groups(readings).size() < 2) {
        throw InputError({study.file.string()},
                         "all readings are at one condition, where no effect can be told from "
                         "another: measure at two or more normal stresses");
    }
}

}  // namespace

KnownRuns runs_for_diagnosis(const ResolvedStudy& study, const SessionOptions& session) {
    if (session.training) return {session.training->runs, atlas_hyperparameters()};
    auto known = known_runs(StudyModelSpace::with_all_effects(study), session.fidelity,
                            session.store, session.listener);
    if (!known) {
        throw InputError(
            {study.study().file.string()},
            "neither the atlas nor the store has enough simulations that can serve this study; set "
            "PENDULAR_ATLAS to the atlas, or simulate with 'pendular calibrate'");
    }
    return std::move(*known);
}

StudyDiagnosis diagnose_study(const ResolvedStudy& study, const Measurements& measurements,
                              const SessionOptions& session) {
    return diagnose_study(study, measurements, session, runs_for_diagnosis(study, session));
}

StudyDiagnosis diagnose_study(const ResolvedStudy& study, const Measurements& measurements,
                              const SessionOptions& session, KnownRuns known) {
    demand_readings(study.study(), measurements);
    StudyDiagnosis result{.readings = readings_to_fit(measurements),
                          .measured = measurements.readings.size()};
    check_readings(result.readings, study, session.fidelity);
    result.models = std::make_unique<StudyModelSpace>(study, conditions_of(result.readings),
                                                      session.fidelity, std::move(known));
    result.evidence = evidence_of(result.readings, measurements.scatter, result.models->direct());
    DiagnosisOptions options{.seed = session.seed};
    options.progress = progress_of(session);
    options.threads = static_cast<std::size_t>(session.threads);
    const Agreement agreement = diagnose_into(result, study.study().model, options);
    const std::shared_ptr<const Predictor> model = result.models->predictor({});
    const Fit& fit = result.diagnosis.base.fit;
    result.mistake = find_unit_mistake(*model, result.readings, study, fit.parameters);
    if (result.mistake && explained_by_effects(result.diagnosis, *result.mistake))
        result.mistake.reset();
    Circumstances beside{.doubtful = doubtful_parts(result.mistake, study, measurements)};
    // The search for shapes takes time, and no shape stands where the study's model fits or where
    // a doubt about the measurement overrules all tests.
    if (beside.doubtful.empty() && !result.diagnosis.base.accepted) {
        result.proposals = propose(study, *result.models, result.evidence, result.readings,
                                   result.diagnosis, options);
        for (const Proposal& each : result.proposals) {
            beside.proposals.push_back({each.fits(), each.shapes.size(), each.penalised_chi2()});
        }
    }
    const bool misfit_to_explain = !result.diagnosis.base.accepted || !beside.doubtful.empty();
    result.recordings = recordings_beside(result, misfit_to_explain, measurements.faults(true));
    beside.recordings_explain_most =
        !result.recordings.empty() && result.recordings.front().explains_most();
    // Proposals and faults of the recordings have a say in the verdict, which is drawn again.
    conclude_anew(result.diagnosis, *result.models, options, beside);
    if (!result.diagnosis.proposals_stand) result.proposals.clear();
    Fit judged = fit;
    // Where something is missing, the verdict says what the readings need.
    if (result.diagnosis.base.accepted)
        add_instrument(judged, *model, result.readings, result.models->direct());
    result.belief =
        belief_in(judged, model->parameters(), agreement, {}, measurements, result.mistake);
    return result;
}

namespace {

Checks checks_of(const StudyDiagnosis& d, const EffectSet& effects, const Prediction& prediction,
                 std::uint64_t seed) {
    const std::size_t direct = d.models->direct().size();
    return check_fit(
        {d.evidence.measured, prediction},
        entries_of(d.readings, d.models->with(effects)->parameters(), direct),
        covariates_of(d.readings, prediction.value, direct),
        NullDraws(d.evidence.measured, d.evidence.errors, seed, DiagnosisOptions{}.draws));
}

}  // namespace

Checks checks_of(const StudyDiagnosis& d, std::uint64_t seed) {
    return checks_of(d, {}, d.diagnosis.base.fit.prediction, seed);
}

std::optional<Checks> remaining_checks(const StudyDiagnosis& d, std::uint64_t seed) {
    if (!d.diagnosis.leaders) return {};
    const FittedModel& model = d.diagnosis.leaders->model;
    return checks_of(d, model.chosen, model.fit.prediction, seed);
}

std::optional<ImpactTable> impacts_of(const StudyDiagnosis& d, std::size_t threads) {
    constexpr std::size_t refitted = 3;  // chosen: each takes two refits; the covariance serves all
    if (d.mistake) return {};
    return impacts(*d.models, d.evidence, d.diagnosis, refitted, threads);
}

/// Smallest ratio of a likely discrepancy to the RMS misfit at which the misfit varies more quickly
/// with the conditions than a discrepancy does [1]: only an excessive discrepancy could then
/// describe the misfit. Chosen: a discrepancy that describes a misfit is about as large as it.
constexpr double rougher = 3;

double remaining_discrepancy(const StudyDiagnosis& d) {
    const Diagnosis& diagnosis = d.diagnosis;
    if (diagnosis.complete) return 0;
    const auto best = std::ranges::min_element(
        diagnosis.tried, {}, [](const FittedModel& each) { return each.fit.chi2; });
    const Fit& fit = diagnosis.leaders               ? diagnosis.leaders->model.fit
                     : best != diagnosis.tried.end() ? best->fit
                                                     : diagnosis.base.fit;
    const double further =
        likely_discrepancy(d.evidence.measured, fit.prediction, conditions_of(d.readings));
    const double misfit = rms_percent(d.readings, fit.prediction.value)[0] / 100;
    return further > 0 && further < rougher * misfit ? std::hypot(d.discrepancy[0], further) : 0;
}

const FittedModel& explaining_model(const Diagnosis& d) {
    if (d.leaders) return d.leaders->model;
    const FittedModel* best = nullptr;
    for (const FittedModel& each : d.confidence_set) {
        if (each.suspect) continue;
        if (each.chosen.empty()) return each;
        if (!best || each.fit.chi2 < best->fit.chi2) best = &each;
    }
    return best ? *best : d.base;
}

std::optional<OddFile> odd_recording(const StudyDiagnosis& d) {
    if (d.readings.size() != d.measured) return std::nullopt;
    return odd_file(d.readings, explaining_model(d.diagnosis).fit.prediction.value);
}

}  // namespace pendular
