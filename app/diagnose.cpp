// `pendular diagnose`: which physical effect is missing from a study's model.
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "analysis/diagnosis/study_evidence.h"
#include "app/belief.h"
#include "app/command.h"
#include "app/console.h"
#include "app/open_session.h"
#include "app/options.h"
#include "reports/diagnosis_figure.h"
#include "reports/diagnosis_report.h"
#include "reports/draw_figure.h"
#include "reports/failure_report.h"
#include "workflow/diagnosis_json.h"
#include "workflow/json.h"
#include "workflow/json_parts.h"

namespace pendular::app {
namespace {

const char* const about_diagnose =
    R"(Says which physical effect is missing from the study's model, if any: fits all readings
jointly, tests what is left of them for every effect that applies, refits with those that they ask
for, and keeps the smallest models that stand. Verdicts: nothing-missing, inconclusive (an effect
that would matter could hide), missing, indistinguishable (several explain the readings alike),
suspect-measurement (one condition or file is off), unknown (something is missing that no known
effect explains). Simulates nothing: predictions are emulated from the atlas and all stored runs.)";

/// What speaks against relying on a verdict, as a sentence; empty where nothing does.
std::string caution(const StudyDiagnosis& d, const Measurements& measurements) {
    if (const std::size_t doubts = doubts_that_set_aside(measurements); doubts > 0) {
        return fmt::format(" Readings that were set aside for {} doubt{} have no part in it.",
                           doubts, doubts == 1 ? "" : "s");
    }
    const bool said = d.diagnosis.verdict == Verdict::suspect_measurement;
    return measurements.doubts.empty() || said
               ? ""
               : " The readings are in doubt: " + measurements.doubts.front().what;
}

}  // namespace

int diagnose(const std::vector<std::string>& arguments) {
    Options options("diagnose STUDY [options]", about_diagnose,
                    "  pendular diagnose my-study\n"
                    "  pendular diagnose my-study --json - --quiet\n",
                    true);
    options.set_threads(0, "refits done side by side");
    std::int64_t seed = 1;
    options.add("seed", &seed, "seed of the random errors that set the limits (default 1)");
    const auto common = options.parse(arguments);
    if (!common) {
        return done;
    }
    Console console(*common);
    const OpenSession session(console, *common, {"diagnosis.json", "figures"}, seed);
    const Measurements& measurements = session->measurements();
    const StudyDiagnosis d = session->diagnose();
    const Belief& belief = d.belief;
    const Diagnosis& diagnosis = d.diagnosis;
    const StudyModels& models = *d.models;
    const Checks checks = checks_of(d, session->options().seed);
    auto json = to_json(diagnosis, models, d.evidence, checks);
    json["line"] = verdict_line(diagnosis, models, checks);
    add_belief(json, belief);
    write_json(common->out_folder() / "diagnosis.json", json);
    console.line(verdict_line(diagnosis, models, checks) + caution(d, measurements));
    if (measurements.doubts.empty() && !d.mistake) {
        console.line(fmt::format("The verdict rests on {}.", error_basis(measurements)));
    }
    print_doubts(console, belief);
    for (const auto& lines : {checks_table(checks), diagnosis_table(diagnosis, models, d.evidence),
                              advice_on(diagnosis, models, common->study.string())}) {
        for (const auto& line : lines) {
            console.line(line);
        }
    }
    for (const auto& note : measurements.notes) {
        console.note(note);
    }
    for (const LeftAside& aside : models.left_aside()) {
        if (aside.without_runs) {
            console.note(fmt::format("{} was not tested: {}", aside.effect, aside.why));
        }
    }
    if (!diagnosis.fit.converged) {
        console.note(
            fmt::format("the fit did not converge ({}): the verdict is of a model that is "
                        "not at its best; 'pendular calibrate' says more",
                        diagnosis.fit.message));
    }
    for (const std::string& why : models.why_unsupported(diagnosis.fit.parameters(0))) {
        console.note(
            fmt::format("The known runs do not support a part of the readings: {}. What seems "
                        "missing there may be the emulator's own error. To simulate there: "
                        "pendular calibrate {}",
                        why, common->study.string()));
    }
    const auto figures = common->out_folder() / "figures";
    draw(diagnosis_figure(diagnosis, models), figures);
    console.line(fmt::format("figure: {}", (figures / "diagnosis.png").string()));
    console.json(json);
    return diagnosis.fit.converged ? done : not_converged;
}

}  // namespace pendular::app
