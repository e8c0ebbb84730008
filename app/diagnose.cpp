// `pendular diagnose`: which physical effect is missing from a study's model.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "analysis/diagnosis/study_evidence.h"
#include "analysis/misfit/compare.h"
#include "app/belief.h"
#include "app/command.h"
#include "app/console.h"
#include "app/open_session.h"
#include "app/options.h"
#include "app/progress.h"
#include "data/remarks/wording.h"
#include "reports/diagnosis_figure.h"
#include "reports/diagnosis_report.h"
#include "reports/diagnosis_table.h"
#include "reports/draw_figure.h"
#include "reports/failure_report.h"
#include "reports/impact_figure.h"
#include "reports/impact_report.h"
#include "reports/next_steps.h"
#include "reports/proposal_figure.h"
#include "reports/proposal_report.h"
#include "reports/scan_figures.h"
#include "reports/suspect_report.h"
#include "reports/undetected_effects.h"
#include "reports/with_error.h"
#include "workflow/confirm_diagnosis.h"
#include "workflow/diagnosis_json.h"
#include "workflow/fit_runs.h"
#include "workflow/impact_json.h"
#include "workflow/json.h"
#include "workflow/json_parts.h"
#include "workflow/order_of_contents.h"
#include "workflow/proposed_effects.h"
#include "workflow/rival_effects.h"
#include "workflow/rivals.h"

namespace pendular::app {
namespace {

const char* const about_diagnose =
    R"(Tests whether the study's model is complete and, if not, which physical effects explain the
residuals. The command fits all readings together, tests the residuals for every effect that applies
to the study, refits the model with the likely effects, and keeps the models with the fewest effects
that describe the readings. Verdicts:
  nothing-missing       the model describes the readings, and every effect that they can reveal would
                        have been detected at its smallest size of interest
  inconclusive          the model describes the readings, but they might not reveal some effects of
                        the smallest size of interest
  missing               one effect, or one set of effects, explains all or most of the misfit
  indistinguishable     several effects explain the residuals equally well
  suspect-measurement   an error in one condition, in one file, or in all files from one
                        on explains the residuals
  unknown               something is missing, and no known effect explains it
If no known effect explains the residuals, the command tries empirical corrections, for example a
torque that depends on the normal stress. Corrections that explain the readings are written to
proposed.toml as [[effect]] tables. If the sensor that a correction concerns is right, add the first
correction with 'pendular add STUDY --proposed 1'.
Entries in the column 'decision' of the table of effects:
  missing                   adding the effect explains the residuals
  missing, with others      adding the effect explains most of the residuals, but not all
  may be missing            one of several effects that explain the residuals equally well
  may be missing too        part of another set of effects that explains the residuals as well
  contains what is missing  the effect explains the residuals, but so does a model with fewer effects
  explains most, not all    adding the effect removes at least 90 % of the excess of chi2, but leaves a
                            misfit: it is not the likely cause, but worth a direct measurement
  does not explain it       the residuals resemble the effect, but adding it leaves a misfit
  no sign of it             something is missing, and the residuals do not resemble this effect
  absent                    nothing is missing, and the effect would have been detected at its
                            smallest size of interest
  cannot be excluded        the readings might not reveal the effect at that size
  refit not converged       the fit with the effect did not converge: it is not tested
  cannot be seen            the readings do not reveal the effect even at the bounds of its parameter
An emulator trained on Pendular's own simulations (the atlas) and all stored ones predicts
the readings. New simulations are made only with --confirm: the command then simulates the states
that reduce the errors of the best models most, and repeats the diagnosis with the results. It ends
when the verdict stays the same, the simulations agree with the emulator and their noise enlarges no
error by more than a fifth, or when the time is over. All results are kept; after Ctrl-C the same
command continues with them.)";

/// Time for --confirm without a number [min].
constexpr double usual_minutes = 5;

/// Sentence on doubts about the readings behind the verdict, or on readings that doubts have set
/// aside; empty without doubts.
std::string caution(const StudyDiagnosis& d, const Measurements& measurements) {
    if (doubts_that_set_aside(measurements) > 0) {
        return " The verdict does not use the readings that were set aside as implausible.";
    }
    const bool said = d.diagnosis.verdict == Verdict::suspect_measurement;
    return measurements.doubts().empty() || said ? ""
                                                 : " Warnings on the readings are listed below.";
}

/// Sentence on the simulations that confirmed the verdict.
std::string confirmation_line(const Confirmation& confirmed) {
    if (confirmed.runs == 0) {
        return "The verdict is not confirmed by simulations: no simulation could finish within the "
               "time limit.";
    }
    const std::string done =
        fmt::format("{} simulation{} in {}", confirmed.runs, confirmed.runs == 1 ? "" : "s",
                    duration(confirmed.seconds));
    return confirmed.settled
               ? fmt::format("The verdict is firm after {}: more of them would change little.",
                             done)
               : fmt::format(
                     "The verdict is not yet firm after {}: {}. To continue, run the same command "
                     "again.",
                     done, confirmed.open);
}

/// Prints the evidence for the verdict and the advice that follows from it.
void print_evidence(Console& console, const StudyDiagnosis& d, const Checks& checks,
                    const std::optional<ImpactTable>& impacts, const Session& session) {
    const Diagnosis& diagnosis = d.diagnosis;
    const StudyModelSpace& models = *d.models;
    const Measurements& measurements = session.measurements();
    console.line(fit_line(diagnosis));
    console.table(checks_table(checks), 3);
    const std::vector<std::string> undetected =
        undetected_table(d, impacts, session.resolved().catalogue());
    console.table(undetected, shown_undetected);
    if (undetected.empty() || console.all()) {
        console.table(diagnosis_table(diagnosis, models, console.all()), 4);
    }
    if (const std::string line =
            rivals_line(d.rivals, diagnosis.base.fit.chi2, session.resolved().catalogue());
        !line.empty()) {
        console.line(line);
    }
    // If the named effects explain the whole misfit, the readings deviate because of these effects.
    const bool explained = diagnosis.verdict == Verdict::missing && diagnosis.complete;
    if (const std::string suspects = suspects_line(diagnosis, d.evidence);
        !suspects.empty() && (!explained || console.all())) {
        console.line(suspects);
    }
    if (const auto remaining = remaining_checks(d, session.options().seed)) {
        for (const std::string& line : incomplete_lines(
                 diagnosis, rms_percent(d.readings, diagnosis.base.fit.prediction.value),
                 rms_percent(d.readings, diagnosis.leaders->model.fit.prediction.value),
                 *remaining)) {
            console.line(line);
        }
    }
    // A proposed change describes the misfit better than a smooth error of the model.
    if (d.proposals.empty()) {
        if (const std::string line =
                discrepancy_line(remaining_discrepancy(d, session.study().model.discrepancy[0]));
            !line.empty()) {
            console.line(line);
        }
    }
    for (const std::string& line :
         proposal_lines(d.proposals, diagnosis.base.fit.chi2, diagnosis.dof)) {
        console.line(line);
    }
    if (const std::string line = undetectable_line(diagnosis, models); !line.empty()) {
        console.line(line);
    }
    for (const std::string& line : close_effects_lines(diagnosis, models)) {
        console.line(line);
    }
    if (const std::string order = order_line(d, session.resolved().catalogue()); !order.empty()) {
        console.line(order);
    }
    if (measurements.doubts().empty() && !d.mistake) {
        console.line(error_basis(measurements));
    }
}

/// Prints a note for each effect that study.toml defines and that is estimated at a bound of its
/// parameter, where something is missing: its true size may lie beyond.
void note_bounds(Console& console, const StudyDiagnosis& d, const Study& study) {
    const Verdict verdict = d.diagnosis.verdict;
    if (verdict == Verdict::nothing_missing || verdict == Verdict::inconclusive) return;
    for (const Finding& finding : d.diagnosis.scan) {
        const Candidate& candidate = d.models->candidates()[finding.candidate];
        const bool of_study =
            std::ranges::find(study.written_effects, candidate.name, &WrittenEffect::name) !=
            study.written_effects.end();
        if (!of_study || candidate.is_switch()) continue;
        const EffectParameter& p = candidate.parameters.front();
        for (const double bound : {p.lower, p.upper}) {
            if (bound == p.neutral || finding.value != bound) continue;
            console.note(fmt::format(
                "The estimate of the effect {} is at a bound of its parameter, {}: if the effect "
                "may be larger, widen 'lower' or 'upper' of its table [[effect]] in study.toml.",
                candidate.name, with_unit(bound, p.unit)));
        }
    }
}

/// Prints notes on the import and on the limits of the models. `study`: name as the user gave it.
void print_notes(Console& console, const StudyDiagnosis& d, const Measurements& measurements,
                 const std::string& study) {
    const Diagnosis& diagnosis = d.diagnosis;
    const StudyModelSpace& models = *d.models;
    for (const Remark& note : measurements.notes()) {
        if (note.kind != Remark::Kind::grain_weight) console.note(text_of(note));
    }
    if (const auto note = note_on_means(d.readings.size(), d.measured)) console.note(*note);
    for (const UntestableEffect& aside : models.untestable_effects()) {
        if (aside.without_runs) {
            console.note(fmt::format("The effect {} was not tested: {}", aside.effect, aside.why));
        }
    }
    if (!diagnosis.base.fit.converged) {
        console.note(
            fmt::format("The fit did not converge ({}): the verdict may differ at the best fit. "
                        "For details: pendular calibrate {}",
                        diagnosis.base.fit.message, study));
    }
    for (const std::string& why : models.why_unsupported(diagnosis.base.fit.parameters(0))) {
        console.note(
            fmt::format("The simulations in atlas and store do not cover a part of the readings: "
                        "{}. A misfit of these readings may be an error of the emulator. To "
                        "simulate their states: pendular calibrate {}",
                        why, study));
    }
}

/// Draws the figures that have panels in `folder`, and returns their names.
std::vector<std::string> draw_all(const std::vector<Figure>& figures,
                                  const std::filesystem::path& folder) {
    std::vector<std::string> names;
    for (const Figure& figure : figures) {
        if (!figure.panels.empty() && draw(figure, folder)) names.push_back(figure.name);
    }
    return names;
}

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

/// JSON array of the proposals of a diagnosis.
nlohmann::ordered_json proposals_json(const StudyDiagnosis& d) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const Proposal& each : d.proposals) {
        std::string tables;
        for (const FittedShape& shape : each.shapes) {
            tables += effect_table(shape.effect);
        }
        json.push_back({{"sentence", sentence_on(each)},
                        {"formula", tables},
                        {"p", each.p},
                        {"fits", each.fits()},
                        {"explained", each.explained},
                        {"chi2", each.model.fit.chi2},
                        {"dof", each.model.fit.dof}});
    }
    return json;
}

}  // namespace

int diagnose(const std::vector<std::string>& arguments) {
    Options options("diagnose STUDY [options]", about_diagnose,
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
    const Measurements& measurements = session->measurements();
    const StudyDiagnosis d = session->diagnose(confirming);
    const Belief& belief = d.belief;
    const Diagnosis& diagnosis = d.diagnosis;
    const StudyModelSpace& models = *d.models;
    const Checks checks = checks_of(d, session->options().seed);
    auto json = to_json(diagnosis, models, d.evidence, checks);
    json["line"] = verdict_line(diagnosis, models, checks);
    json["readings"] = {{"measured", d.measured}, {"tested", d.readings.size()}};
    json["recordings"] = recordings_json(d.recordings);
    json["model_effects"] = names_of(session->study().model.effects);
    json["rivals"] = to_json(d.rivals);
    json["proposed"] = proposals_json(d);
    json["runs"] = runs_json(d.models->simulation().emulator().runs());
    json["confirmed"] = to_json(d.confirmed);
    const std::optional<ImpactTable> impacts =
        impacts_of(d, static_cast<std::size_t>(session->options().threads));
    const std::vector<NextStep> steps =
        next_steps(d, impacts, session->resolved(), common->study_word());
    json["to_do"] = texts_of(steps);
    json["impact"] = impacts ? to_json(*impacts) : nullptr;
    add_belief(json, belief);
    write_proposed(common->out_folder() / "proposed.toml", proposed_of(d));
    write_json(common->out_folder() / "diagnosis.json", json);
    const std::string shown = recordings_line(d.recordings);
    if (diagnosis.recordings_first) console.line(shown);
    console.answer(verdict_line(diagnosis, models, checks) + caution(d, measurements));
    if (!diagnosis.recordings_first && !shown.empty()) console.line(shown);
    if (d.confirmed) console.line(confirmation_line(*d.confirmed));
    for (std::size_t k = 0; k < belief.reasons.size(); ++k) {
        if (k != belief.misfit_reason) console.line("Warning: " + belief.reasons[k]);
    }
    for (const std::string& line : suspect_lines(d)) {
        console.line(line);
    }
    if (const std::string friction = friction_line(d); !friction.empty()) console.line(friction);
    print_limits(console, models.simulation().emulator().runs(), d.readings,
                 rivals_of(d).front().fit.parameters(0));
    print_evidence(console, d, checks, impacts, *session.operator->());
    if (impacts && console.all()) console.table(impact_table(*impacts), impacts->impacts.size());
    for (const std::string& line : step_lines(steps)) {
        console.line(line);
    }
    print_notes(console, d, measurements, common->study_word());
    note_bounds(console, d, session->study());
    const bool named =
        diagnosis.verdict == Verdict::missing || diagnosis.verdict == Verdict::indistinguishable;
    if (const auto& cell = session->study().cell; named && cell) {
        for (const std::string& note : implausible_offsets(diagnosis, models, d.readings, *cell))
            console.note(note);
    }
    const auto figures = common->out_folder() / "figures";
    std::vector<Figure> drawn = {diagnosis_figure(diagnosis, models)};
    std::ranges::move(scan_figures(diagnosis, models), std::back_inserter(drawn));
    if (!d.proposals.empty()) {
        drawn.push_back(
            proposal_figure(d.proposals.front(), d.readings, diagnosis.base.fit.prediction));
    }
    if (impacts) drawn.push_back(impact_figure(*impacts));
    console.json(json);  // before the figures, which need gnuplot
    console.figures(figures, draw_all(drawn, figures));
    console.next(next_command(diagnosis, steps, common->study_word()));
    return diagnosis.base.fit.converged ? done : not_converged;
}

}  // namespace pendular::app
