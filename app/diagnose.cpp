// `pendular diagnose`: which physical effect is missing from a study's model.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/command.h"
#include "app/console.h"
#include "app/open_session.h"
#include "app/options.h"
#include "reports/diagnosis_figures.h"
#include "reports/diagnosis_output.h"
#include "reports/diagnosis_table.h"
#include "reports/impact_report.h"
#include "reports/next_steps.h"
#include "reports/proposal_report.h"
#include "reports/verdict_report.h"
#include "workflow/json/diagnosis.h"
#include "workflow/json/parts.h"
#include "workflow/proposed_effects.h"

namespace pendular::app {
namespace {

const char* const about_verdicts =
    R"(Tests whether the study's model is complete and, if not, which physical effects explain the
residuals. The command fits all readings together, tests the residuals for every effect that applies
to the study, refits the model with the likely effects, and keeps the models with the fewest effects
that describe the readings. Verdicts:
  nothing-missing       the model describes the readings, and every effect that they can reveal would
                        have been detected at the size that matters
  inconclusive          the model describes the readings, but they might not reveal some effects of
                        the size that matters
  missing               one effect, or one set of effects, explains all or most of the misfit
  indistinguishable     several effects explain the residuals equally well
  suspect-measurement   an error in one condition, in one file, or in all files from one
                        on explains the residuals
  unknown               something is missing, and no known effect explains it, or none as well as a
                        proposed change
If something is missing, the command tries empirical corrections, for example a
torque that depends on the normal stress. Corrections that explain the readings are written to
proposed.toml as [[effect]] tables. If the sensor that a correction concerns is right, add the first
correction with 'pendular add STUDY --proposed 1'.
Entries in the column 'decision' of the table of effects:
)";

const char* const about_confirming =
    R"(An emulator trained on Pendular's own simulations (the atlas) and all stored ones predicts
the readings. New simulations are made only with --confirm: the command then simulates the states
that reduce the errors of the best models most, and repeats the diagnosis with the results. It ends
when the verdict stays the same, the simulations agree with the emulator and their noise enlarges no
error by more than a fifth, or when the time is over. All results are kept; after Ctrl-C the same
command continues with them.)";

/// Time for --confirm without a number [min].
constexpr double usual_minutes = 5;

/// Proposed effects of a diagnosis, with a sentence on each as its summary.
ProposedEffects proposed_of(const StudyDiagnosis& d) {
    ProposedEffects proposed;
    for (const Proposal& each : d.proposals) {
        proposed.proposals.emplace_back();
        for (const FittedShape& shape : each.shapes) {
            WrittenEffect effect = shape.effect;
            effect.summary = sentence_on(shape);
            proposed.proposals.back().push_back(effect.name);
            proposed.effects.push_back(std::move(effect));
        }
    }
    return proposed;
}

}  // namespace

int diagnose(const std::vector<std::string>& arguments) {
    const std::string about = about_verdicts + decisions_in_words() + about_confirming;
    Options options("diagnose STUDY [options]", about.c_str(),
                    "  pendular diagnose my-study\n"
                    "  pendular diagnose my-study --json - --quiet\n"
                    "  pendular diagnose my-study --confirm 5\n",
                    true);
    options.set_threads(0,
                        "number of threads; each fits one model or simulates one sample at a time");
    std::int64_t seed = 1;
    options.add(
        "seed", &seed,
        "seed of the simulated random errors from which p values and power are computed, and of "
        "new simulations (default 1)");
    std::optional<double> confirming;
    options.add_time("confirm", &confirming, usual_minutes,
                     "check the verdict by new simulations, for at most MINUTES (default: 5)");
    options.offer_runs_of();
    const auto common = options.parse(arguments);
    if (!common) {
        return done;
    }
    Console console(*common);
    const OpenSession session(console, *common, {"diagnosis.json", "proposed.toml", "figures"},
                              seed);
    const StudyDiagnosis d = session->diagnose(confirming);
    const Diagnosis& diagnosis = d.diagnosis;
    const StudyModelSpace& models = *d.models;
    const Checks checks = checks_of(d, session->options().seed);
    const std::optional<ImpactTable> impacts =
        impacts_of(d, static_cast<std::size_t>(session->options().threads));
    const std::vector<NextStep> steps =
        next_steps(d, impacts, session->resolved(), common->study_word());
    const auto json = to_json(d, checks, impacts, session->study(),
                              {verdict_line(diagnosis, models, checks), sentences_on(d.proposals),
                               texts_of(steps), d.confirmed ? why_open(*d.confirmed) : ""});
    write_proposed(common->out_folder() / "proposed.toml", proposed_of(d));
    write_json(common->out_folder() / "diagnosis.json", json);
    console.print(diagnosis_output({d, checks, remaining_checks(d, session->options().seed),
                                    impacts, steps, session->resolved(), session->measurements(),
                                    common->study_word(), console.all()}));
    console.json(json);  // before the figures, which need gnuplot
    console.figures(common->out_folder() / "figures", diagnosis_figures(d, impacts));
    console.next(next_command(diagnosis, steps, common->study_word()));
    return diagnosis.base.fit.converged ? done : not_converged;
}

}  // namespace pendular::app
