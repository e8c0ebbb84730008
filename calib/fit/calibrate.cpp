#include "calib/fit/calibrate.h"

#include <fmt/format.h>

#include <string>

namespace pendular {

Fit calibrate(LearningModel& learning, const Measured& measured, const CalibrationOptions& options,
              const CalibrationReport& report) {
    Eigen::VectorXd at = options.start.value_or(start_of(learning.model()));
    const auto settled = [&](const Fit& fit) {
        return ((fit.parameters - at).cwiseAbs().array() <=
                options.settled * fit.covariance.diagonal().cwiseSqrt().array())
            .all();
    };
    Fit best;
    double excess = 1;
    std::string unsettled;
    for (int round = 1; round <= options.most_rounds; ++round) {
        learning.improve(at, excess);
        const Model& model = learning.model();
        best = fit(model, measured, at);
        if (report) {
            report(round, best);
        }
        const Enlargement enlarged = enlargement_by_runs(best, measured, model.parameters());
        excess = enlarged.excess(options.largest_enlargement);
        unsettled =
            !settled(best) ? "the parameters still changed"
            : !learning.confirmed()
                ? "simulations still differed from the emulator's predictions"
                : fmt::format("the noise of the simulations still enlarged {}", text_of(enlarged));
        const bool done =
            round >= options.fewest_rounds && settled(best) && excess <= 1 && learning.confirmed();
        at = best.parameters;
        // More simulation does not help to determine parameters that the readings do not determine.
        if (done || learning.exhausted() || (round >= options.fewest_rounds && !best.converged)) {
            return best;
        }
    }
    if (options.most_rounds == 1) {
        return best;
    }
    best.converged = false;
    best.message = unsettled + " after the last round of simulations";
    return best;
}

}  // namespace pendular
