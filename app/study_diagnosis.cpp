#include "app/study_diagnosis.h"

#include <fmt/format.h>

#include <set>
#include <string>
#include <string_view>

#include "analysis/compare.h"
#include "analysis/study_evidence.h"
#include "app/interrupt.h"
#include "app/stored_runs.h"
#include "calib/calibrate_study.h"
#include "calib/calibration.h"
#include "data/input_error.h"
#include "data/quantity.h"
#include "data/replicate_groups.h"

namespace pendular::app {
namespace {

std::string name_of(const Explanation& explanation, const StudyModels& models) {
    std::string name;
    for (const std::size_t k : explanation.chosen) {
        name += (name.empty() ? "" : " + ") + models.candidates()[k].name;
    }
    return name.empty() ? "the model as it is" : name;
}

/// What may be wrong where an implausible value of this quantity was kept.
std::string cause_of(const std::string& quantity) {
    if (quantity == "solid_fraction") return "the gap or the bead mass (solid fraction)";
    if (quantity == "stress_ratio") return "the torque or the normal force (stress ratio)";
    return "the " + std::string(pendular::quantity(quantity).meaning);
}

/// A measurement that cannot be right comes before any effect.
void suspect_measurement(StudyDiagnosis& result) {
    std::set<std::string> suspects;
    if (result.mistake) {
        suspects.insert(
            fmt::format("the unit of the {} {}", result.mistake->column, result.mistake->files));
    }
    for (const Doubt& doubt : result.input.measurements.doubts) {
        if (!doubt.set_aside && result.input.study.import.keep_implausible) {
            suspects.insert(cause_of(doubt.quantity));
        }
    }
    if (suspects.empty()) return;
    result.diagnosis.verdict = Verdict::suspect_measurement;
    result.diagnosis.effects.clear();
    result.diagnosis.cosines.resize(0, 0);
    result.diagnosis.suspects.assign(suspects.begin(), suspects.end());
}

KnownRuns known_for(const Study& study, const CommonOptions& options) {
    const auto store = open_store(options);
    auto known = known_runs(StudyModels::with_all_effects(study), options.fidelity, store.get());
    if (!known) {
        throw InputError({study.file.string()},
                         "neither the atlas nor the store has enough runs that can serve this "
                         "study; set PENDULAR_ATLAS to the atlas, or make runs with 'pendular "
                         "calibrate'");
    }
    return std::move(*known);
}

}  // namespace

StudyDiagnosis diagnosed(const CommonOptions& options, std::uint64_t seed,
                         const std::filesystem::path& output) {
    StudyDiagnosis result{.input = read_input(options, {output, "figures"})};
    const Study& study = result.input.study;
    result.readings = dry_first(result.input.measurements);
    check_range(result.readings, study, options.fidelity);
    if (result.readings.empty()) {
        throw InputError({study.file.string()},
                         fmt::format("there is no reading to diagnose; 'pendular import {}' says "
                                     "what was left out and why",
                                     options.study.string()));
    }
    if (replicate_groups(result.readings).size() < 2) {
        throw InputError({study.file.string()},
                         "all readings are at one condition, where every effect looks like every "
                         "other: measure at two normal stresses at least");
    }
    const KnownRuns known = known_for(study, options);
    const auto models = [&] {
        return std::make_unique<StudyModels>(study, conditions_of(result.readings),
                                             options.fidelity, known);
    };
    result.models = models();
    result.evidence =
        evidence_of(result.readings, result.input.measurements.scatter, result.models->direct());
    const InterruptGuard guard;
    DiagnosisOptions own{.seed = seed};
    own.progress = [&](std::string_view what, std::size_t at, std::size_t of) {
        if (guard.token().stop_requested()) {
            throw dem::Interrupted();
        }
        if (!options.quiet && at == 0) {
            fmt::print(stderr, "{}: {}\n", what, of);
        }
    };
    own.another = models;
    own.threads = static_cast<std::size_t>(options.threads);
    result.diagnosis = diagnose(*result.models, result.evidence, own);
    result.mistake = find_unit_mistake(result.models->with({}), result.readings, study,
                                       result.diagnosis.fit.parameters);
    suspect_measurement(result);
    return result;
}

std::vector<Rival> rivals_of(const Diagnosis& diagnosis, const StudyModels& models) {
    std::vector<Rival> rivals;
    for (const Explanation& each : diagnosis.confidence_set) {
        if (!each.suspect) {
            rivals.push_back({name_of(each, models), &models.with(each.chosen), each.fit.parameters,
                              each.fit.covariance});
        }
    }
    if (rivals.empty()) {
        rivals.push_back({"the model as it is", &models.with({}), diagnosis.fit.parameters,
                          diagnosis.fit.covariance});
    }
    return rivals;
}

}  // namespace pendular::app
