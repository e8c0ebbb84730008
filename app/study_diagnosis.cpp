#include "app/study_diagnosis.h"

#include <fmt/format.h>

#include <string>
#include <string_view>

#include "analysis/compare.h"
#include "analysis/study_evidence.h"
#include "app/interrupt.h"
#include "app/stored_runs.h"
#include "calib/calibration.h"
#include "data/input_error.h"

namespace pendular::app {
namespace {

std::string name_of(const Explanation& explanation, const StudyModels& models) {
    std::string name;
    for (const std::size_t k : explanation.chosen) {
        name += (name.empty() ? "" : " + ") + models.candidates()[k].name;
    }
    return name.empty() ? "the model as it is" : name;
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

StudyDiagnosis diagnosed(const CommonOptions& options, std::uint64_t seed) {
    StudyDiagnosis result{.input = read_input(options.study)};
    const Study& study = result.input.study;
    result.readings = dry_first(result.input.measurements);
    check_range(result.readings, study, options.fidelity);
    if (condition_groups(result.readings).size() < 2) {
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
