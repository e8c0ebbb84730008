#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>

#include "analysis/diagnosis/where_it_fails.h"
#include "analysis/misfit/compare.h"
#include "app/belief.h"
#include "app/cohesion_options.h"
#include "app/command.h"
#include "app/console.h"
#include "app/open_session.h"
#include "app/options.h"
#include "calib/fit/calibrate_study.h"
#include "calib/fit/calibration.h"
#include "data/recordings/replicate_groups.h"
#include "data/remarks/wording.h"
#include "reports/comparison_figures.h"
#include "reports/draw_figure.h"
#include "reports/failure_report.h"
#include "reports/joined.h"
#include "reports/tables.h"
#include "workflow/fit_file.h"
#include "workflow/fit_runs.h"
#include "workflow/json.h"
#include "workflow/json_parts.h"
#include "workflow/rival_effects.h"

namespace pendular::app {

namespace {

/// Beginning of the answer with the effects of the model: "With torque-offset and lid-slip, the
/// relative RMS error of the model is".
std::string with_effects(const ModelSettings& model) {
    return model.effects.empty() ? "The relative RMS error of the model is"
                                 : fmt::format("With {}, the relative RMS error of the model is",
                                               joined(names_of(model.effects), "and"));
}

/// Part of the answer on readings that were predicted, not fitted, and that the model does not
/// describe: "; the model does not describe the 12 readings that were predicted, not fitted
/// (p < 0.001)". Empty where it describes them or there are none.
std::string verdict_on_predicted(const Calibration& c, const Comparison& comparison) {
    if (c.fitted == c.readings.size() || comparison.predicted.p() >= incredible_p) return "";
    return fmt::format(
        "; the model does not describe the {} readings that were predicted, not fitted (p {})",
        c.readings.size() - c.fitted, p_text(comparison.predicted.p()));
}

}  // namespace

int compare(const std::vector<std::string>& arguments) {
    Options options(
        "compare STUDY [options]",
        "Compares the calibrated model with the readings. Prints chi2 by quantity, condition and "
        "file, and\n"
        "tests for lack of fit, trends and outliers. Draws figures as SVG, PNG and PDF with their "
        "numbers as\n"
        "CSV: readings and model, residuals, quantiles of the residuals against normal quantiles "
        "(qq), parts\n"
        "of chi2 (chi2_ledger), profile likelihood (profile) and confidence regions of the "
        "parameters\n"
        "(corner). Run 'pendular calibrate' first. No simulation is made.",
        "  pendular compare examples/polystyrene\n"
        "  pendular compare my-study --out results --json -\n",
        true);
    options.leave_out({"fidelity", "store", "threads", "quiet"});
    const CohesionLineOptions cohesion(options, "as calibrated");
    const auto common = options.parse(arguments);
    if (!common) {
        return done;
    }
    Console console(*common);
    const Session session(common->study, {.fidelity = common->fidelity},
                          places_of(*common, {"compare.json", "figures"}));
    const auto out = common->out_folder();
    const Measurements& measurements = session.measurements();
    FittedStudy compared = session.compare();
    if (cohesion.given(options)) {
        compared.calibration.cohesion = cohesion.stated(options, compared.calibration.cohesion);
        add_cohesion_lines(compared.model->model(), compared.calibration);
    }
    const Calibration& c = compared.calibration;
    const Comparison& comparison = compared.comparison;
    const Belief& belief = compared.belief;
    const WhereItFails where = where_it_fails(compared, measurements);
    auto json = to_json(comparison, c.cohesion_lines, where);
    json["runs"] = runs_json(c.runs, c.known);
    add_belief(json, belief);
    write_json(out / "compare.json", json);
    console.answer(fmt::format(
        "{} {:.2f} % in shear stress and {:.2f} % in solid fraction; for all readings, {}{}. {}",
        with_effects(c.model), comparison.rms_percent[0], comparison.rms_percent[1],
        misfit_text(comparison.total),
        belief.believable() ? verdict_on_predicted(c, comparison) : "",
        belief.believable() ? error_basis(measurements)
                            : warning_on(belief, "the fitted friction coefficient")));
    print_doubts(console, belief, 1);
    if (c.fitted < c.readings.size()) {
        console.line(fmt::format("Readings that were predicted, not fitted: {}.",
                                 misfit_text(comparison.predicted)));
    }
    print_limits(console, c.runs, c.readings, c.fit.parameters(0));
    console.table(failure_table(where), 3);
    console.table(predictions_table(comparison, !console.all()), 5);
    if (console.all()) console.table(misfit_table(comparison), 0);
    if (console.all()) console.table(cohesion_table(c.cohesion_lines), 0);
    for (const Remark& note : measurements.notes()) {
        if (note.kind != Remark::Kind::grain_weight) console.note(text_of(note));
    }
    for (const auto& notes : {c.cohesion_notes, c.notes}) {
        for (const auto& note : notes) {
            console.note(note);
        }
    }
    if (!c.fit.converged) {
        console.note("The calibration did not converge.");
    }
    console.json(json);  // before the figures, which need gnuplot
    std::vector<std::string> drawn_figures;
    for (auto figure : comparison_figures(*compared.model, c, comparison)) {
        if (!belief.believable()) figure.title += " (the fit is not to be used: see compare.json)";
        if (draw(figure, out / "figures")) drawn_figures.push_back(figure.name);
    }
    console.figures(out / "figures", drawn_figures);
    constexpr double significant = 0.05;  // as in the diagnosis (`DiagnosisOptions`)
    const bool fits = belief.believable() && comparison.total.p() >= significant;
    if (replicate_groups(c.readings).size() > 1) {
        console.next(fmt::format("pendular {} {}",
                                 fits && !c.model.effects.empty() ? "next" : "diagnose",
                                 common->study_word()));
    }
    return done;
}

}  // namespace pendular::app
