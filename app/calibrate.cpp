#include <fmt/format.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "app/cohesion_options.h"
#include "app/command.h"
#include "app/console.h"
#include "app/open_session.h"
#include "app/options.h"
#include "calib/fit/calibrate_study.h"
#include "data/input_error.h"
#include "data/recordings/reading_groups.h"
#include "reports/fit_report.h"
#include "workflow/json/fit.h"

namespace pendular::app {
namespace {

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
                       "also compute the profile likelihood interval of each parameter");
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
    console.print(calibration_output(result, measurements, common->study_word(), console.all()));
    console.json(to_json(c, comparison, belief));
    if (replicate_groups(c.readings).size() < 2) {
        // Nothing tests the model, and the notes say so.
    } else if (!belief.believable() || comparison.total.p() < significant_p) {
        console.next(fmt::format("pendular diagnose {}", common->study_word()));
    } else {
        console.next(fmt::format("pendular compare {}", common->study_word()));
    }
    return c.fit.converged && !belief.meaningless ? done : not_converged;
}

}  // namespace pendular::app
