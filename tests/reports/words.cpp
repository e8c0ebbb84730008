#include "reports/words.h"

#include <gtest/gtest.h>

namespace pendular {
namespace {

/// Fit of one parameter, 0.09 +- 0.01.
Fit fit_of_friction() {
    Fit fit;
    fit.parameters = Eigen::VectorXd::Constant(1, 0.09);
    fit.covariance = Eigen::MatrixXd::Constant(1, 1, 1e-4);
    return fit;
}

TEST(ProgressSentence, SaysThatSimulationsCheckAFitThatNeededNone) {
    const Fit fit = fit_of_friction();
    Event event{.kind = Event::Kind::round, .number = 1, .total = 2, .fit = &fit};
    EXPECT_EQ(progress_sentence(event),
              "From earlier simulations: friction = 0.090 +- 0.010. New simulations check this fit "
              "now.");
    event.runs.runs = 4;  // simulations that fill a gap came first
    EXPECT_EQ(progress_sentence(event), "Round 1: friction = 0.090 +- 0.010.");
    event.runs.runs = 0;
    event.total = 1;  // nothing is to check the fit
    EXPECT_EQ(progress_sentence(event), "Round 1: friction = 0.090 +- 0.010.");
    event.number = event.total = 2;
    EXPECT_EQ(progress_sentence(event), "Round 2: friction = 0.090 +- 0.010.");
}

}  // namespace
}  // namespace pendular
