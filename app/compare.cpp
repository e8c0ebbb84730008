#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>

#include "analysis/diagnosis/where_it_fails.h"
#include "analysis/misfit/compare.h"
#include "app/belief.h"
#include "app/command.h"
#include "app/console.h"
#include "app/open_session.h"
#include "app/options.h"
#include "calib/fit/calibrate_study.h"
#include "calib/fit/calibration.h"
#include "reports/comparison_figures.h"
#include "reports/draw_figure.h"
#include "reports/failure_report.h"
#include "reports/tables.h"
#include "workflow/fit_file.h"
#include "workflow/json.h"
#include "workflow/json_parts.h"

namespace pendular::app {

namespace {

/// "with torque-offset, lid-slip: "; empty where there are none.
std::string with_effects(const ModelSettings& model) {
    std::string names;
    for (const auto& effect : model.effects) {
        names += (names.empty() ? "with " : ", ") + effect.name;
    }
    return names.empty() ? "" : names + ": ";
}

/// "; the 12 readings that were only predicted are not described (p = 1e-9)": where what was fitted
/// is described and what was only predicted is not.
std::string verdict_on_predicted(const Calibration& c, const Comparison& comparison) {
    if (c.fitted == c.readings.size() || comparison.predicted.p() >= incredible_p) return "";
    return fmt::format("; the {} readings that were only predicted are not described (p = {:.2g})",
                       c.readings.size() - c.fitted, comparison.predicted.p());
}

}  // namespace

int compare(const std::vector<std::string>& arguments) {
    Options options(
        "compare STUDY [options]",
        "Puts the calibrated model beside the readings: misfit by observable, "
        "condition and file, where the model\n"
        "fails beyond what its parameters could take over (lack of fit, trends and runs "
        "along what was varied,\n"
        "conditions and files that stand out), and figures as SVG, PNG and PDF with their numbers "
        "as CSV. Needs 'pendular "
        "calibrate' first;\n"
        "simulates nothing itself.",
        "  pendular compare examples/polystyrene\n"
        "  pendular compare my-study --out results --json -\n",
        true);
    CohesionOptions cohesion;
    options.add("lowest-reduced-pressure", &cohesion.lowest_reduced_pressure,
                "cohesion lines go through points from this P* on [1] (default: as calibrated)");
    const auto common = options.parse(arguments);
    if (!common) {
        return done;
    }
    Console console(*common);
    const Session session(common->study, {.fidelity = common->fidelity},
                          places_of(*common, {"compare.json", "figures"}));
    const auto out = common->out_folder();
    std::optional<CohesionOptions> drawn;
    if (options.given("lowest-reduced-pressure")) {
        check_options(cohesion);
        drawn = cohesion;
    }
    const Measurements& measurements = session.measurements();
    const ComparedStudy compared = session.compare(drawn);
    const auto& [c, model, comparison, where, belief] = compared;
    auto json = to_json(comparison, c.cohesion_lines, where);
    add_belief(json, belief);
    write_json(out / "compare.json", json);
    console.line(fmt::format(
        "{}chi2 = {:.2f} for {} degrees of freedom (p = {:.2g}); RMS error {:.2f} % in shear "
        "stress, {:.2f} % in solid fraction{}{}",
        with_effects(c.model), comparison.total.chi2, comparison.total.dof, comparison.total.p(),
        comparison.rms_percent[0], comparison.rms_percent[1],
        belief.believable() ? verdict_on_predicted(c, comparison) : "",
        verdict_on(belief, error_basis(measurements))));
    print_doubts(console, belief);
    if (c.fitted < c.readings.size()) {
        console.line(fmt::format(
            "of which chi2 = {:.2f} for {} from readings that were only "
            "predicted (p = {:.2g})",
            comparison.predicted.chi2, comparison.predicted.dof, comparison.predicted.p()));
    }
    for (const auto& table :
         {comparison_table(comparison), failure_table(where), cohesion_table(c.cohesion_lines)}) {
        for (const auto& line : table) {
            console.line(line);
        }
    }
    for (const auto& note : measurements.notes) {
        console.note(note);
    }
    for (const auto& notes : {c.cohesion_notes, c.notes}) {
        for (const auto& note : notes) {
            console.note(note);
        }
    }
    if (!c.fit.converged) {
        console.note("the calibration had not converged");
    }
    for (auto figure : comparison_figures(model, c, comparison)) {
        if (!belief.believable()) figure.title += " (in doubt: see compare.json)";
        draw(figure, out / "figures");
        console.line(
            fmt::format("figure: {}", (out / "figures" / (figure.name + ".png")).string()));
    }
    console.json(json);
    return done;
}

}  // namespace pendular::app
