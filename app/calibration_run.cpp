#include "app/calibration_run.h"

#include <fmt/format.h>

#include <string>
#include <utility>

#include "app/stored_runs.h"
#include "calib/calibrate_study.h"

namespace pendular::app {

void choose_rounds(CalibrationRequest& request, std::optional<KnownRuns> known, bool confirm) {
    request.known = std::move(known);
    if (!request.known) {
        // Direct simulation is confirmed by a third round.
        request.options.fewest_rounds -= !confirm;
        return;
    }
    request.known->orders_more = confirm;
    request.options.fewest_rounds = 2;
    if (!confirm) {
        request.options.fewest_rounds = request.options.most_rounds = 1;
    }
}

Calibration run_calibration(Console& console, const CommonOptions& common, const Study& study,
                            const Measurements& measurements, CalibrationRequest request,
                            RunStore* store, bool reuse, std::stop_token stop) {
    std::string what = "round 1";
    request.stage = [&](std::string_view name) { what = name; };
    const Workers workers{common.threads, std::move(stop),
                          [&](const EnsembleProgress& p) { console.progress(what, p); }, store,
                          reuse};
    const auto report = [&](int round, const Fit& fit) {
        console.end_progress();
        if (!common.quiet) {
            fmt::print(stderr, "round {}: friction = {}\n", round,
                       with_error(fit.parameters(0), fit.standard_error(0)));
        }
        what = fmt::format("round {}", round + 1);
    };
    try {
        Calibration c = calibrate_study(study, measurements, request, workers, report);
        console.end_progress();
        return c;
    } catch (const dem::Interrupted&) {
        console.end_progress();
        throw store ? interrupted_with(*store) : dem::Interrupted();
    }
}

}  // namespace pendular::app
