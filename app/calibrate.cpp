#include <fmt/format.h>

#include <array>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "analysis/misfit/compare.h"
#include "app/belief.h"
#include "app/cohesion_options.h"
#include "app/command.h"
#include "app/console.h"
#include "app/open_session.h"
#include "app/options.h"
#include "calib/fit/calibrate_study.h"
#include "calib/fit/calibration.h"
#include "data/input_error.h"
#include "data/recordings/replicate_groups.h"
#include "data/remarks/wording.h"
#include "reports/parameter_name.h"
#include "reports/tables.h"
#include "sim/catalogue/effect_catalogue.h"
#include "workflow/fit_file.h"
#include "workflow/json_parts.h"

namespace pendular::app {
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

/// p value of chi2 [1] below which a misfit is pointed out although the fit can be used.
constexpr double noticed_p = 0.05;

/// Text of a fitted parameter after its name: "0.1204 +- 0.0019 (0.0017 from the readings, 0.00084
/// from the simulations)".
std::string estimate_text(const Calibration& c, std::size_t k) {
    const auto i = static_cast<Eigen::Index>(k);
    const bool stated = c.model.discrepancy != std::array{0.0, 0.0};
    const std::string& unit = c.parameters[k].unit;
    const std::string value = estimate_text(c.fit, i, unit);
    if (!(c.fit.standard_error(i) > 0) || !c.fit.determines(i)) return value;
    return fmt::format(
        "{} ({} from the readings, {} from the {})", value,
        with_unit(c.fit.measurement_error(i), unit), with_unit(c.fit.simulation_error(i), unit),
        stated ? "simulations and the model discrepancy in study.toml" : "simulations");
}

void print_result(Console& console, const Calibration& c, const Comparison& comparison,
                  const Belief& belief, const std::string& basis) {
    const std::string first = estimate_text(c, 0);
    console.answer(
        belief.believable()
            ? fmt::format("Fitted: {} = {}.", c.parameters[0].name, first)
            : warning_on(belief, fmt::format("the fitted {}, {}",
                                             parameter_in_words(c.parameters[0].name), first)));
    for (std::size_t k = 1; k < c.parameters.size(); ++k) {
        console.line(fmt::format("{} = {}.", c.parameters[k].name, estimate_text(c, k)));
    }
    print_doubts(console, belief, 1);
    if (c.profile) {
        console.line(fmt::format(
            "The 68 % profile likelihood interval of the friction coefficient is {:.4f} to {:.4f}.",
            c.profile->first, c.profile->second));
    }
    const double p = comparison.fitted.p();
    if (belief.misfit_reason != 0) {  // else the answer states it
        console.line(fmt::format("The fit has {}{}.", misfit_text(comparison.fitted),
                                 p < noticed_p && p >= incredible_p
                                     ? ": more than the errors explain; 'pendular diagnose' tests "
                                       "what is missing"
                                     : ""));
    }
    console.line(basis);
    print_limits(console, c.runs, c.readings, c.fit.parameters(0));
    console.line(basis_of(c));
    if (c.fitted < c.readings.size()) {
        console.line(fmt::format("{} wet readings are predicted {}: {}.",
                                 c.readings.size() - c.fitted, source_of_wet(c),
                                 misfit_text(comparison.predicted)));
    }
    if (console.all()) console.table(predictions_table(comparison), 0);
    console.table(cohesion_table(c.cohesion_lines), 8);
    for (const auto& note : c.cohesion_notes) {
        console.note(note);
    }
    for (const auto& note : c.notes) {
        console.note(note);
    }
    if (!c.fit.converged) {
        console.note("The fit did not converge: " + c.fit.message);
    }
}

const char* const about_calibrate =
    R"(Fits the friction coefficient between grains to the shear stress and solid fraction of all dry
readings together, and predicts the wet readings with this coefficient (with fit_to = "all" in
study.toml, the fit includes the wet readings). The model is a discrete-element simulation. In the
least-squares fit, an emulator replaces the simulation: a statistical model trained on the
simulations that come with the program (the atlas) and on the simulations in the store. Then new
simulations at the fitted friction coefficient train the emulator further, and the fit is repeated,
until simulations and emulator agree and the noise of the simulations enlarges no error by more
than a fifth. Writes fit.json to the results folder.)";

}  // namespace

int calibrate(const std::vector<std::string>& arguments) {
    FitOptions fit;
    Options options("calibrate STUDY [options]", about_calibrate,
                    "  pendular calibrate examples/polystyrene --no-confirm\n"
                    "  pendular calibrate examples/polystyrene --fidelity quick --confirm 5\n"
                    "  pendular calibrate my-study --cold --profile --json -\n",
                    true);
    std::int64_t seed = 1;
    options.add("seed", &seed, "seed of the simulations (default 1)");
    bool no_confirm = false;
    std::optional<double> confirming = std::numeric_limits<double>::infinity();
    options.add_time("confirm", &confirming, std::numeric_limits<double>::infinity(),
                     "check the fit by new simulations, for at most MINUTES (default: no limit)");
    options.add_switch("no-confirm", &no_confirm,
                       "do not check the fit by new simulations (with --cold: simulations are made "
                       "for the fit, but none to check it)");
    options.add_switch("cold", &fit.cold,
                       "simulate all states that the fit needs anew, without the simulations "
                       "that come with the program (the atlas) and without those in the store; "
                       "the new simulations are kept in the store");
    const CohesionLineOptions cohesion(options);
    options.add_switch("profile", &fit.profile,
                       "also compute the profile likelihood interval of the friction coefficient");
    options.offer_runs_of();
    const auto common = options.parse(arguments);
    if (!common) {
        return done;
    }
    Console console(*common);
    fit.cohesion = cohesion.stated(options);
    if (no_confirm && options.given("confirm")) {
        throw InputError("--confirm and --no-confirm contradict each other: leave out one of them");
    }
    if (no_confirm) confirming.reset();
    set_confirmation(confirming, fit);
    const OpenSession session(console, *common, {"fit.json", "fit_runs.csv", "figures"}, seed,
                              OpenSession::Access::changes);
    const Measurements& measurements = session->measurements();
    const FittedStudy result = session->calibrate(fit);
    const Calibration& c = result.calibration;
    const Comparison& comparison = result.comparison;
    const Belief& belief = result.belief;
    print_result(console, c, comparison, belief, error_basis(measurements));
    for (const Remark& note : measurements.notes()) {
        console.note(text_of(note));
    }
    if (beyond_transients(measurements)) {
        console.note(fmt::format("Import excluded {}. To list them: pendular import {} --all",
                                 excluded_text(measurements), common->study_word()));
    }
    auto json = to_json(c, comparison);
    add_belief(json, belief);
    console.json(json);
    constexpr double significant = 0.05;  // as in the diagnosis (`DiagnosisOptions`)
    if (replicate_groups(c.readings).size() < 2) {
        console.note(
            "All readings are at one condition: nothing tests the model. Measure at two or more "
            "normal stresses.");
    } else if (!belief.believable() || comparison.total.p() < significant) {
        console.next(fmt::format("pendular diagnose {}", common->study_word()));
    } else {
        console.next(fmt::format("pendular compare {}", common->study_word()));
    }
    return c.fit.converged && !belief.meaningless ? done : not_converged;
}

}  // namespace pendular::app
