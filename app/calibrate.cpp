#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "analysis/misfit/compare.h"
#include "app/belief.h"
#include "app/command.h"
#include "app/console.h"
#include "app/open_session.h"
#include "app/options.h"
#include "calib/fit/calibrate_study.h"
#include "calib/fit/calibration.h"
#include "reports/tables.h"
#include "workflow/fit_file.h"
#include "workflow/json_parts.h"

namespace pendular::app {
namespace {

/// What simulations a calibration rests on.
std::string basis_of(const Calibration& c) {
    std::size_t ordered = 0;
    std::string why;
    for (const Order& order : c.orders) {
        ordered += order.runs;
        why += fmt::format("{}{} {}", why.empty() ? ": " : ", ", order.runs, order.why);
    }
    return fmt::format("emulated from {} runs, of which {} ordered at {} fidelity{}", c.runs.size(),
                       ordered, c.fidelity.name, why);
}

void print_result(Console& console, const Calibration& c, const Comparison& comparison,
                  const Belief& belief, const std::string& basis) {
    for (std::size_t k = 0; k < c.parameters.size(); ++k) {
        const auto i = static_cast<Eigen::Index>(k);
        console.line(fmt::format(
            "{} = {} (measurement {:.2g}, simulation {:.2g}){}", c.parameters[k].name,
            with_error(c.fit.parameters(i), c.fit.standard_error(i)), c.fit.measurement_error(i),
            c.fit.simulation_error(i), k == 0 ? verdict_on(belief, basis) : ""));
    }
    print_doubts(console, belief);
    if (c.profile) {
        console.line(fmt::format("68 % profile interval: {:.4g} to {:.4g}", c.profile->first,
                                 c.profile->second));
    }
    console.line(fmt::format(
        "chi2 = {:.2f} for {} degrees of freedom (p = {:.2g}); errors are not scaled by chi2/dof; "
        "{}",
        comparison.fitted.chi2, comparison.fitted.dof, comparison.fitted.p(), basis_of(c)));
    if (c.fitted < c.readings.size()) {
        console.line(fmt::format(
            "{} wet readings predicted by {} without any further parameter: chi2 = {:.2f} for {} "
            "degrees of freedom (p = {:.2g})",
            c.readings.size() - c.fitted,
            c.model.base == "rumpf" ? "Rumpf's cohesion on the simulated dry law" : "simulation",
            comparison.predicted.chi2, comparison.predicted.dof, comparison.predicted.p()));
    }
    for (const auto& line : predictions_table(comparison)) {
        console.line(line);
    }
    for (const auto& line : cohesion_table(c.cohesion_lines)) {
        console.line(line);
    }
    for (const auto& note : c.cohesion_notes) {
        console.note(note);
    }
    for (const auto& note : c.notes) {
        console.note(note);
    }
    if (!c.fit.converged) {
        console.note("the fit did not converge: " + c.fit.message);
    }
}

}  // namespace

int calibrate(const std::vector<std::string>& arguments) {
    FitOptions fit;
    Options options("calibrate STUDY [options]",
                    "Fits the intergranular friction to shear stress and solid fraction of all dry "
                    "readings together,\n"
                    "by discrete-element simulation inside a Ceres least-squares loop, and "
                    "predicts the wet readings\n"
                    "with it (fit_to = \"all\" in the study fits them too). An emulator of the "
                    "atlas and of all stored\n"
                    "runs answers first; fresh runs at the optimum confirm it, until both agree. "
                    "Writes fit.json to the\n"
                    "results folder.",
                    "  pendular calibrate examples/polystyrene --no-confirm\n"
                    "  pendular calibrate examples/polystyrene --fidelity quick\n"
                    "  pendular calibrate my-study --cold --profile --json -\n",
                    true);
    std::int64_t seed = 1;
    options.add("seed", &seed, "seed of the simulations (default 1)");
    bool no_confirm = false;
    options.add_switch(
        "no-confirm", &no_confirm,
        "simulate nothing: take the emulator's answer as it is (with --cold: one round "
        "fewer)");
    options.add_switch(
        "cold", &fit.cold,
        "from neither the atlas nor earlier runs: simulate all that the fit needs; those of it "
        "are kept in the store all the same");
    options.add("lowest-reduced-pressure", &fit.cohesion.lowest_reduced_pressure,
                "cohesion lines go through points from this P* on [1] (default 2.3)");
    options.add_switch("profile", &fit.profile,
                       "profile likelihood interval of the friction as well");
    const auto common = options.parse(arguments);
    if (!common) {
        return done;
    }
    Console console(*common);
    check_options(fit.cohesion);
    fit.confirm = !no_confirm;
    const OpenSession session(console, *common, {"fit.json", "fit_runs.csv", "figures"}, seed);
    const Measurements& measurements = session->measurements();
    const CalibratedStudy result = session->calibrate(fit);
    const auto& [c, comparison, belief] = result;
    print_result(console, c, comparison, belief, error_basis(measurements));
    for (const auto& note : measurements.notes) {
        console.note(note);
    }
    if (!measurements.excluded.empty()) {
        console.note(fmt::format(
            "{} ranges of rows were left out of the readings; 'pendular import' lists them",
            measurements.excluded.size()));
    }
    auto json = to_json(c, comparison);
    add_belief(json, belief);
    console.json(json);
    constexpr double significant = 0.05;
    if (!belief.believable() || comparison.total.p() < significant) {
        console.line(
            fmt::format("What may be missing: pendular diagnose {}", common->study.string()));
    }
    return c.fit.converged && !belief.meaningless ? done : not_converged;
}

}  // namespace pendular::app
