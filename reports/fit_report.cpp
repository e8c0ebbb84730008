#include "reports/fit_report.h"

#include <fmt/format.h>

#include <array>

#include "calib/fit/calibration_notes.h"
#include "calib/fit/measured.h"
#include "data/recordings/reading_groups.h"
#include "data/remarks/wording.h"
#include "reports/failure_report.h"
#include "reports/shared_errors.h"
#include "reports/tables.h"
#include "reports/with_error.h"
#include "reports/words.h"
#include "sim/catalogue/effect_catalogue.h"
#include "workflow/rivals.h"

namespace pendular {

std::string warning_on(const Belief& belief, const std::string& what) {
    if (belief.believable()) return "";
    return fmt::format("{} Do not use {}{}.", as_sentence(belief.reasons.front()), what,
                       belief.meaningless ? ": it is meaningless" : "");
}

void add_doubts(Output& output, const Belief& belief, std::size_t named_already,
                const std::string& heading) {
    for (std::size_t k = named_already; k < belief.reasons.size(); ++k) {
        const std::string& reason = belief.reasons[k];
        output.line(heading + as_sentence(reason));
    }
}

void add_limits(Output& output, const std::vector<dem::RunResult>& runs,
                const std::vector<Reading>& readings, double friction) {
    for (const auto& note : {implausible_friction(friction), extrapolation_note(runs, readings)}) {
        if (note) output.line("Note: " + *note);
    }
}

std::string discrepancy_text(const std::array<double, 2>& discrepancy) {
    const std::string ratio = fmt::format("{:.2g} % of the stress ratio", 100 * discrepancy[0]);
    return discrepancy[1] > 0
               ? fmt::format("{} and {:.2g} % of the solid fraction", ratio, 100 * discrepancy[1])
               : ratio;
}

namespace {

/// Sentence on the simulations that a calibration's emulator was trained on.
std::string basis_of(const Calibration& c) {
    std::size_t ordered = 0;
    std::string why;
    for (const SimulatedRuns& each : c.simulated) {
        ordered += each.runs;
        why += fmt::format("{}{} {}", why.empty() ? ": " : ", ", each.runs, each.why);
    }
    if (ordered == 0) {
        return fmt::format(
            "The emulator was trained on {} simulations that existed already; no simulation was "
            "run for this study.",
            c.runs.size());
    }
    return fmt::format(
        "The emulator was trained on {} simulations; {} of them were run for this study at {} "
        "fidelity{}.",
        c.runs.size(), ordered, c.fidelity.name, why);
}

/// How the model predicts the wet readings that were not fitted, as the end of a sentence.
std::string source_of_wet(const Calibration& c) {
    if (const int cohesions = fitted_cohesions(c.model, c.grains, c.liquid))
        return fmt::format(
            "by straight lines of the stress ratio in 1/P*, with {} fitted to the readings at P* "
            ">= "
            "{}",
            cohesions == 1 ? "one cohesion" : fmt::format("{} cohesions", cohesions),
            lowest_cohesion_pressure);
    const Study study{.grains = c.grains, .liquid = c.liquid, .model = c.model};
    return level_of(study) == closures::Level::simulation
               ? "with the fitted friction coefficient"
               : "by the formula of the base model and the simulated dry law";
}

/// "an inexact model", with its error where that is larger than expected.
std::string inexact_model(const Calibration& c) {
    return c.fit.inexactness > 1 ? fmt::format("a model that errs by {:.2g} % of the stress ratio",
                                               100 * c.fit.inexactness * c.model.discrepancy[0])
                                 : "an inexact model";
}

/// Text of a fitted parameter after its name: "0.1205 +- 0.0023 (0.0017 from the readings, 0.00081
/// from the simulations, 0.0012 from an inexact model)".
std::string estimate_text(const Calibration& c, std::size_t k) {
    const auto i = static_cast<Eigen::Index>(k);
    const std::string& unit = c.parameters[k].unit;
    const std::string value = estimate_text(c.fit, i, unit);
    if (!(c.fit.standard_error(i) > 0) || !c.fit.determines(i)) return value;
    const auto part = [&](double error, const std::string& cause) {
        return error > 0 ? fmt::format(", {} from {}", with_unit(error, unit), cause) : "";
    };
    return fmt::format("{} ({} from the readings, {} from the simulations{}{})", value,
                       with_unit(c.fit.measurement_error(i), unit),
                       with_unit(c.fit.simulation_error(i), unit),
                       part(c.fit.discrepancy_error(i), inexact_model(c)),
                       part(c.fit.instrument_error(i), "what all readings share"));
}

/// Beginning of the answer with the effects of the model: "With torque-offset and lid-slip, the
/// relative RMS error of the model is".
std::string with_effects(const ModelSettings& model) {
    return model.effects.empty() ? "The relative RMS error of the model is"
                                 : fmt::format("With {}, the relative RMS error of the model is",
                                               joined(names_of(model.effects), "and"));
}

/// How well the model describes the fitted readings, in sentences; empty where nothing tests it.
std::string agreement_text(const Calibration& c, const Belief& belief) {
    const Agreement& fitted = belief.fitted;
    if (replicate_groups(part(c.readings, 0, c.fitted)).size() < 2)
        return "";  // nothing tests the model
    const bool nearly = fitted.degree() == Agreement::Degree::nearly;
    std::string text;
    if (nearly)
        text = fmt::format(
            "The model describes the fitted readings only with an error of {}, more than "
            "independent codes differ by, which the standard error contains; chi2 is {:.1f} with "
            "it, {:.1f} with the {} that are expected. The model misses the shear stress by {:.2g} "
            "% and the solid fraction by {:.2g} %.",
            discrepancy_text(fitted.discrepancy), fitted.as_inexact.chi2, fitted.misfit.chi2,
            discrepancy_text(c.model.discrepancy), fitted.rms_percent[0], fitted.rms_percent[1]);
    else if (fitted.discrepancy != std::array{0.0, 0.0})
        text = fmt::format(
            "The model describes the fitted readings within their errors and an error of the "
            "model of "
            "{}, {}.",
            discrepancy_text(fitted.discrepancy),
            c.model.discrepancy_stated ? "as study.toml allows"
                                       : "about what independent codes differ by");
    if (belief.predicted && belief.predicted->degree() == Agreement::Degree::nearly)
        text += fmt::format(
            "{}It describes the {} readings that were predicted, not fitted, only with an error of "
            "{}.",
            text.empty() ? "" : " ", belief.predicted->readings,
            discrepancy_text(belief.predicted->discrepancy));
    return text;
}

/// Whether a reason against the fit states chi2 of the readings that were predicted.
bool states_misfit_of_predicted(const Belief& belief) {
    return belief.predicted && belief.predicted->degree() == Agreement::Degree::fails;
}

/// First sentences on a fit: its friction, and what it may be used for.
std::string answer_of(const Calibration& c, const Belief& belief) {
    const std::string first = estimate_text(c, 0);
    if (belief.believable())
        return fmt::format("Fitted: {} = {}{}. {}", c.parameters[0].name, first, systematic_text(c),
                           agreement_text(c, belief));
    if (belief.for_fitted_only)
        return fmt::format(
            "Fitted to the {} readings, and not to be used for others: {} = {}{}. {}",
            dry_count(c.readings) == c.fitted ? "dry" : "fitted", c.parameters[0].name, first,
            systematic_text(c), as_sentence(belief.reasons.front()));
    return warning_on(
        belief, fmt::format("the fitted {}, {}", parameter_in_words(c.parameters[0].name), first));
}

}  // namespace

Output calibration_output(const FittedStudy& result, const Measurements& measurements,
                          const std::string& study, bool all) {
    const Calibration& c = result.calibration;
    const Comparison& comparison = result.comparison;
    const Belief& belief = result.belief;
    Output output;
    output.answer(answer_of(c, belief));
    for (std::size_t k = 1; k < c.parameters.size(); ++k) {
        output.line(fmt::format("{} = {}.", c.parameters[k].name, estimate_text(c, k)));
    }
    add_shared_errors(output, c);
    add_doubts(output, belief, 1);
    for (std::size_t k = 0; k < c.profile.size(); ++k) {
        const auto [lower, upper] = c.profile[k];
        const std::string& unit = c.parameters[k].unit;
        output.line(k == 0 ? fmt::format("The 68 % profile likelihood interval of the friction "
                                         "coefficient is {:.4f} to {:.4f}.",
                                         lower, upper)
                           : fmt::format("The 68 % profile likelihood interval of {} is {} to {}.",
                                         c.parameters[k].name, with_unit(lower, unit, 4),
                                         with_unit(upper, unit, 4)));
    }
    const double p = comparison.fitted.p();
    if (belief.misfit_reason != 0) {  // else the answer states it
        const bool nearly = belief.fitted.degree() == Agreement::Degree::nearly;
        output.line(fmt::format(
            "The fit has {}{}.", misfit_text(comparison.fitted),
            p < significant_p && (p >= incredible_p || nearly)
                ? fmt::format(": more than the {}errors explain; 'pendular diagnose' tests what is "
                              "missing",
                              nearly ? "expected " : "")
                : ""));
    }
    output.line(error_basis(measurements));
    add_limits(output, c.runs, c.readings, c.fit.parameters(0));
    output.line(basis_of(c));
    if (c.fitted < c.readings.size()) {
        output.line(fmt::format(
            "{} wet readings are predicted {}{}.", c.readings.size() - c.fitted, source_of_wet(c),
            states_misfit_of_predicted(belief) ? "" : ": " + misfit_text(comparison.predicted)));
    }
    if (all) output.table(predictions_table(comparison), 0);
    output.table(cohesion_table(c.cohesion_lines), 8);
    if (!c.cohesion_lines.empty() && !belief.believable() && !belief.for_fitted_only)
        output.line("These cohesions are in doubt for the reasons above, as the friction is.");
    output.notes(c.cohesion_notes);
    output.notes(c.notes);
    if (!c.fit.converged) {
        output.note("The fit did not converge: " + c.fit.message);
    }
    for (const Remark& note : measurements.notes()) {
        output.note(text_of(note));
    }
    if (beyond_transients(measurements)) {
        output.note(fmt::format("Import excluded {}. To list them: pendular import {} --all",
                                excluded_text(measurements), study));
    }
    if (replicate_groups(c.readings).size() < 2) {
        output.note(
            "All readings are at one condition: nothing tests the model. Measure at two or more "
            "normal stresses.");
    }
    return output;
}

Output comparison_output(const FittedStudy& compared, const WhereItFails& where,
                         const Measurements& measurements, bool all) {
    const Calibration& c = compared.calibration;
    const Comparison& comparison = compared.comparison;
    const Belief& belief = compared.belief;
    Output output;
    output.answer(fmt::format(
        "{} {:.2f} % in shear stress and {:.2f} % in solid fraction; for all readings, {}. {}",
        with_effects(c.model), comparison.rms_percent[0], comparison.rms_percent[1],
        misfit_text(comparison.total),
        belief.believable()      ? error_basis(measurements)
        : belief.for_fitted_only ? as_sentence(belief.reasons.front())
                                 : warning_on(belief, "the fitted friction coefficient")));
    const std::string text = agreement_text(c, belief);
    if (belief.believable() && comparison.total.p() < significant_p && !text.empty())
        output.line(text);
    add_doubts(output, belief, 1);
    if (c.fitted < c.readings.size() && !states_misfit_of_predicted(belief)) {
        output.line(fmt::format("Readings that were predicted, not fitted: {}.",
                                misfit_text(comparison.predicted)));
    }
    add_limits(output, c.runs, c.readings, c.fit.parameters(0));
    output.table(failure_table(where), 3);
    output.table(predictions_table(comparison, !all), 5);
    if (all) output.table(misfit_table(comparison), 0);
    if (all) output.table(cohesion_table(c.cohesion_lines), 0);
    for (const Remark& note : measurements.notes()) {
        if (note.kind != Remark::Kind::grain_weight) output.note(text_of(note));
    }
    output.notes(c.cohesion_notes);
    output.notes(c.notes);
    if (!c.fit.converged) output.note("The calibration did not converge.");
    return output;
}

}  // namespace pendular
