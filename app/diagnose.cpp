// `pendular diagnose`: which physical effect is missing from a study's model.
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "analysis/compare.h"
#include "analysis/diagnosis.h"
#include "analysis/study_evidence.h"
#include "app/command.h"
#include "app/console.h"
#include "app/interrupt.h"
#include "app/options.h"
#include "app/stored_runs.h"
#include "app/study_input.h"
#include "calib/calibration.h"
#include "calib/study_models.h"
#include "data/input_error.h"
#include "reports/diagnosis_figure.h"
#include "reports/diagnosis_report.h"
#include "reports/failure_report.h"
#include "reports/json.h"

namespace pendular::app {
namespace {

const char* const about =
    R"(Says which physical effect is missing from the study's model, if any: fits all readings
jointly, tests what is left of them for every effect that applies, refits with those that they ask
for, and keeps the smallest models that stand. Verdicts: nothing-missing, inconclusive (an effect
that would matter could hide), missing, indistinguishable (several explain the readings alike),
suspect-measurement (one condition or file is off), unknown (something is missing that no known
effect explains). Simulates nothing: predictions are emulated from the atlas and all stored runs.)";

KnownRuns known_for(const Study& study, const CommonOptions& common) {
    const auto store = open_store(common);
    auto known = known_runs(StudyModels::with_all_effects(study), common.fidelity, store.get());
    if (!known) {
        throw InputError({study.file.string()},
                         "neither the atlas nor the store has enough runs that can serve this "
                         "study; set PENDULAR_ATLAS to the atlas, or make runs with 'pendular "
                         "calibrate'");
    }
    return std::move(*known);
}

}  // namespace

int diagnose(const std::vector<std::string>& arguments) {
    Options options("diagnose STUDY [options]", about,
                    "  pendular diagnose my-study\n"
                    "  pendular diagnose my-study --json - --quiet\n",
                    true);
    std::int64_t seed = 1;
    options.add("seed", &seed, "seed of the random errors that set the limits (default 1)");
    const auto common = options.parse(arguments);
    if (!common) {
        return done;
    }
    Console console(*common);
    const auto [study, measurements] = read_input(common->study);
    const auto readings = dry_first(measurements);
    check_range(readings, study, common->fidelity);
    if (condition_groups(readings).size() < 2) {
        throw InputError({study.file.string()},
                         "all readings are at one condition, where every effect looks like every "
                         "other: measure at two normal stresses at least");
    }
    const StudyModels models(study, conditions_of(readings), common->fidelity,
                             known_for(study, *common));
    const Evidence evidence = evidence_of(readings, measurements.scatter);
    const InterruptGuard guard;
    DiagnosisOptions own{.seed = checked_seed(seed)};
    own.progress = [&](std::string_view what, std::size_t at, std::size_t of) {
        if (guard.token().stop_requested()) {
            throw dem::Interrupted();
        }
        if (!common->quiet && at == 0) {
            fmt::print(stderr, "{}: {}\n", what, of);
        }
    };
    const Diagnosis diagnosis = diagnose(models, evidence, own);
    const Checks checks =
        check_fit(diagnosis.residuals(evidence), entries_of(readings, models.with({}).parameters()),
                  covariates_of(readings), NullDraws(evidence.errors, own.seed, own.draws));
    const auto json = to_json(diagnosis, models, evidence, checks);
    write_json(common->out_folder() / "diagnosis.json", json);
    console.line(verdict_line(diagnosis, models, checks));
    for (const auto& lines : {checks_table(checks), diagnosis_table(diagnosis, models, evidence),
                              advice_on(diagnosis, models, common->study.string())}) {
        for (const auto& line : lines) {
            console.line(line);
        }
    }
    for (const auto& note : measurements.notes) {
        console.note(note);
    }
    for (const LeftAside& aside : models.left_aside()) {
        if (aside.untold) {
            console.note(fmt::format("{} was not tested: {}", aside.effect, aside.why));
        }
    }
    if (!diagnosis.fit.converged) {
        console.note(
            fmt::format("the fit did not converge ({}): the verdict is of a model that is "
                        "not at its best; 'pendular calibrate' says more",
                        diagnosis.fit.message));
    }
    for (const std::string& beyond : models.beyond(diagnosis.fit.parameters(0))) {
        console.note(fmt::format(
            "the emulator extrapolates: {} of the runs it knows; what seems missing there may be "
            "its own error ('pendular calibrate' orders runs there)",
            beyond));
    }
    const auto figures = common->out_folder() / "figures";
    draw(diagnosis_figure(diagnosis, models), figures);
    console.line(fmt::format("figure: {}", (figures / "diagnosis.png").string()));
    console.json(json);
    return diagnosis.fit.converged ? done : not_converged;
}

}  // namespace pendular::app
