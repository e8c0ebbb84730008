#include "reports/diagnosis_output.h"

#include <fmt/format.h>

#include <algorithm>

#include "data/remarks/wording.h"
#include "reports/diagnosis_report.h"
#include "reports/diagnosis_table.h"
#include "reports/failure_report.h"
#include "reports/fit_report.h"
#include "reports/impact_report.h"
#include "reports/odd_file_report.h"
#include "reports/other_causes.h"
#include "reports/proposal_report.h"
#include "reports/verdict_report.h"
#include "reports/with_error.h"
#include "reports/words.h"
#include "workflow/rivals.h"

namespace pendular {
namespace {

/// Sentence on doubts about the readings behind the verdict, or on readings that doubts have set
/// aside; empty without doubts.
std::string caution(const StudyDiagnosis& d, const Measurements& measurements) {
    if (doubts_that_set_aside(measurements) > 0) {
        return " The verdict does not use the readings that were set aside as implausible.";
    }
    if (const std::string doubt = doubt_line(d); !doubt.empty()) return " " + doubt;
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
                     done, why_open(confirmed));
}

/// Adds the evidence for the verdict and the advice that follows from it.
void add_evidence(Output& output, const DiagnosisParts& parts) {
    const auto& [d, checks, remaining, impacts, steps, study, measurements, name, all] = parts;
    const Diagnosis& diagnosis = d.diagnosis;
    const StudyModelSpace& models = *d.models;
    const std::string inexact = inexactness_line(d, study.study());
    output.line(fit_line(diagnosis) + (inexact.empty() ? "" : " " + inexact));
    output.table(checks_table(checks), 3);
    const std::vector<std::string> undetected = undetected_table(d, impacts, study.catalogue());
    output.table(undetected, shown_undetected);
    if (undetected.empty() || all) {
        output.table(diagnosis_table(diagnosis, models, all), 4);
    }
    output.line(rivals_line(d.rivals, diagnosis.base.fit.chi2, study.catalogue()));
    // If the named effects explain the whole misfit, the readings deviate because of these effects.
    const bool explained = diagnosis.verdict == Verdict::missing && diagnosis.complete;
    if (const std::string suspects = suspects_line(diagnosis, d.evidence);
        !suspects.empty() && (!explained || all)) {
        output.line(suspects);
    }
    if (remaining) {
        for (const std::string& line : incomplete_lines(
                 diagnosis, rms_percent(d.readings, diagnosis.base.fit.prediction.value),
                 rms_percent(d.readings, diagnosis.leaders->model.fit.prediction.value),
                 *remaining)) {
            output.line(line);
        }
    }
    // A proposed change describes the misfit better than a smooth error of the model.
    if (d.proposals.empty()) {
        output.line(discrepancy_line(remaining_discrepancy(d), d.discrepancy[1]));
    }
    output.lines(proposal_lines(d.proposals, diagnosis.base.fit.chi2, diagnosis.dof));
    output.line(undetectable_line(diagnosis, models));
    output.lines(close_effects_lines(diagnosis, models));
    output.line(order_line(d, study.catalogue()));
    if (measurements.doubts().empty() && !d.mistake) {
        output.line(error_basis(measurements));
    }
}

/// Adds a note for each effect that study.toml defines and that is estimated at a bound of its
/// parameter, where something is missing: its true size may lie beyond.
void add_notes_on_bounds(Output& output, const StudyDiagnosis& d, const Study& study) {
    if (is_of_fitting_model(d.diagnosis.verdict)) return;
    for (const Finding& finding : d.diagnosis.scan) {
        const Candidate& candidate = d.models->candidates()[finding.candidate];
        const bool of_study =
            std::ranges::find(study.written_effects, candidate.name, &WrittenEffect::name) !=
            study.written_effects.end();
        if (!of_study || candidate.is_switch()) continue;
        const EffectParameter& p = candidate.parameters.front();
        for (const double bound : {p.lower, p.upper}) {
            if (bound == p.neutral || finding.value != bound) continue;
            output.note(fmt::format(
                "The estimate of the effect {} is at a bound of its parameter, {}: if the effect "
                "may be larger, widen 'lower' or 'upper' of its table [[effect]] in study.toml.",
                candidate.name, with_unit(bound, p.unit)));
        }
    }
}

/// Adds notes on the import and on the limits of the models. `study`: name as the user gave it.
void add_notes(Output& output, const StudyDiagnosis& d, const Measurements& measurements,
               const std::string& study) {
    const Diagnosis& diagnosis = d.diagnosis;
    const StudyModelSpace& models = *d.models;
    for (const Remark& note : measurements.notes()) {
        if (note.kind != Remark::Kind::grain_weight) output.note(text_of(note));
    }
    if (const auto note = note_on_means(d.readings.size(), d.measured)) output.note(*note);
    for (const UntestableEffect& aside : models.untestable_effects()) {
        if (aside.without_runs) {
            output.note(fmt::format("The effect {} was not tested: {}", aside.effect, aside.why));
        }
    }
    if (!diagnosis.base.fit.converged) {
        output.note(
            fmt::format("The fit did not converge ({}): the verdict may differ at the best fit. "
                        "For details: pendular calibrate {}",
                        diagnosis.base.fit.message, study));
    }
    for (const std::string& why : models.why_unsupported(diagnosis.base.fit.parameters(0))) {
        output.note(
            fmt::format("The simulations in atlas and store do not cover a part of the readings: "
                        "{}. A misfit of these readings may be an error of the emulator. To "
                        "simulate their states: pendular calibrate {}",
                        why, study));
    }
}

}  // namespace

std::string why_open(const Confirmation& confirmed) {
    switch (confirmed.open) {
        case Confirmation::Open::no_simulation:
            return "no simulation was made";
        case Confirmation::Open::verdict_changed:
            return "the verdict changed with the last simulations";
        case Confirmation::Open::emulator_disagrees:
            return "the last simulations differed from the emulator's predictions";
        case Confirmation::Open::noise:
            return fmt::format("the noise of the simulations enlarges {}",
                               text_of(confirmed.enlargement));
        case Confirmation::Open::nothing:
            break;
    }
    return "";
}

Output diagnosis_output(const DiagnosisParts& parts) {
    const auto& [d, checks, remaining, impacts, steps, study, measurements, name, all] = parts;
    const Diagnosis& diagnosis = d.diagnosis;
    const StudyModelSpace& models = *d.models;
    const Belief& belief = d.belief;
    Output output;
    const std::string shown = recordings_line(d.recordings);
    if (diagnosis.recordings_first) output.line(shown);
    output.answer(verdict_line(diagnosis, models, checks) + caution(d, measurements));
    if (!diagnosis.recordings_first) output.line(shown);
    output.line(undetected_shift_line(diagnosis, impacts));
    if (d.confirmed) output.line(confirmation_line(*d.confirmed));
    for (std::size_t k = 0; k < belief.reasons.size(); ++k) {
        // The line on the recordings may give the same reason.
        if (k != belief.misfit_reason && shown.find(belief.reasons[k]) == std::string::npos)
            output.line("Warning: " + belief.reasons[k]);
    }
    output.lines(suspect_lines(d));
    // A suspect recording is the verdict itself.
    if (diagnosis.verdict != Verdict::suspect_measurement) output.line(odd_file_line(d));
    output.line(friction_line(d));
    add_limits(output, models.simulation().emulator().runs(), d.readings,
               rivals_of(d).front().fit.parameters(0));
    add_evidence(output, parts);
    if (impacts && all) output.table(impact_table(*impacts), impacts->impacts.size());
    output.lines(step_lines(steps));
    add_notes(output, d, measurements, name);
    add_notes_on_bounds(output, d, study.study());
    const bool named =
        diagnosis.verdict == Verdict::missing || diagnosis.verdict == Verdict::indistinguishable;
    if (const auto& cell = study.study().cell; named && cell) {
        output.notes(implausible_offsets(diagnosis, models, d.readings, *cell));
    }
    return output;
}

}  // namespace pendular
