#include "app/closures.h"

#include <fmt/format.h>

#include "data/input_error.h"
#include "workflow/state_prediction.h"

namespace pendular::app {

void print_closures(const closures::ClosureValues& values, double stress_ratio, Console& console) {
    console.line(fmt::format(
        "Formulas of Badetti et al. (2018), evaluated with the values above, without standard "
        "errors (for comparison: the stress ratio above is {:.4g}):",
        stress_ratio));
    for (const auto& each : closures::closure_quantities) {
        console.line(fmt::format("  {:<52} {:.4g}", each.text, values.*each.value));
    }
}

std::optional<closures::ClosureValues> print_closures_of(const dem::RunResult& run,
                                                         const CommonOptions& common,
                                                         const RunStore* store, Console& console) {
    if (!run.parameters.wetting) return {};
    std::optional<closures::ClosureValues> values;
    try {
        values = StatePredictor(common.fidelity, store, run.parameters.stiffness_number)
                     .closures_of(run);
    } catch (const InputError&) {
        // Without earlier runs there is no stress ratio of dry grains either.
    }
    if (values) {
        print_closures(*values, run[dem::Observable::stress_ratio].value, console);
    } else {
        console.line(
            "The formulas of Badetti et al. (2018) are not evaluated: they need the stress ratio "
            "of "
            "dry grains, which the simulations in atlas and store do not give for this friction, "
            "inertial number, damping and these effects.");
    }
    return values;
}

}  // namespace pendular::app
