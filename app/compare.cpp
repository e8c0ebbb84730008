#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>

#include "analysis/diagnosis/where_it_fails.h"
#include "analysis/misfit/compare.h"
#include "app/cohesion_options.h"
#include "app/command.h"
#include "app/console.h"
#include "app/open_session.h"
#include "app/options.h"
#include "calib/fit/calibrate_study.h"
#include "calib/fit/calibration.h"
#include "data/recordings/reading_groups.h"
#include "reports/fit_report.h"
#include "reports/misfit_figures.h"
#include "workflow/json/diagnosis.h"
#include "workflow/json/parts.h"

namespace pendular::app {

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
    FittedStudy compared = session.compare();
    if (cohesion.given(options)) {
        compared.calibration.cohesion = cohesion.stated(options, compared.calibration.cohesion);
        add_cohesion_lines(compared.model->model(), compared.calibration);
    }
    const Calibration& c = compared.calibration;
    const Comparison& comparison = compared.comparison;
    const Belief& belief = compared.belief;
    const WhereItFails where = where_it_fails(compared, session.measurements());
    const auto json = to_json(compared, where);
    write_json(out / "compare.json", json);
    console.print(comparison_output(compared, where, session.measurements(), console.all()));
    console.json(json);  // before the figures, which need gnuplot
    std::vector<Figure> figures = comparison_figures(*compared.model, c, comparison);
    if (!belief.believable()) mark_as_rejected(figures);
    console.figures(out / "figures", figures);
    const bool fits = belief.believable() && comparison.total.p() >= significant_p;
    if (replicate_groups(c.readings).size() > 1) {
        console.next(fmt::format("pendular {} {}",
                                 fits && !c.model.effects.empty() ? "next" : "diagnose",
                                 common->study_word()));
    }
    return done;
}

}  // namespace pendular::app
