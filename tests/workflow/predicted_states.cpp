#include "workflow/predicted_states.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "data/input_error.h"
#include "sim/dem/simulation_error.h"
#include "sim/runs/run_settings.h"

namespace pendular::workflow_predicted_states_test {

const StatePredictor& predictor() {
    static const StatePredictor made(fidelity_named("quick"), nullptr, 1000);
    return made;
}

/// Dry and wet states, more than a thread predicts at a time, and one outside of the range.
std::vector<RequestedState> some_states() {
    std::vector<RequestedState> states;
    for (int k = 0; k < 40; ++k) {
        RequestedState state{.friction = 0.05 + 0.005 * k, .inertial_number = 0.001 * (k % 5)};
        if (k % 3 != 0) {
            state.reduced_pressure = 0.8 + 0.2 * k;
            state.liquid_content = 0.01;
        }
        states.push_back(state);
    }
    states.push_back({.friction = 0.95});
    return states;
}

// Products of matrices round otherwise than products with vectors. A variance is the small
// difference of two numbers, which is why its rounding errors show most: the standard errors of one
// state differ by up to 2e-6 of themselves.
TEST(PredictedStates, AreThoseOfEachStateAlone) {
    const std::vector<RequestedState> requested = some_states();
    const PredictedStates found = predict_states(predictor(), requested, {.slopes = true});
    for (std::size_t k = 0; k + 1 < requested.size(); ++k) {
        const StatePrediction alone = predictor().at(requested[k]);
        const auto row = static_cast<Eigen::Index>(k);
        EXPECT_TRUE(found.why_not[k].empty());
        std::size_t numbers = 0;
        for (const EmulatedObservable& one : alone.observables) {
            const auto column =
                std::ranges::find(found.observables, one.which) - found.observables.begin();
            EXPECT_NEAR(found.value(row, column), one.value.value, 1e-6 * one.value.standard_error);
            EXPECT_NEAR(found.standard_error(row, column), one.value.standard_error,
                        1e-4 * one.value.standard_error);
            EXPECT_NEAR(found.slopes[0](row, column), one.slopes[0].value,
                        1e-6 * one.slopes[0].standard_error);
            ++numbers;
        }
        // What a dry state does not have is no number.
        EXPECT_EQ((found.value.row(row).array() == found.value.row(row).array()).count(), numbers);
        EXPECT_EQ(std::isnan(found.bridge_volume(row)), alone.state.dry());
    }
}

TEST(PredictedStates, OfDryGrainsAloneHaveNoBridges) {
    const PredictedStates found = predict_states(predictor(), {{.friction = 0.2}});
    EXPECT_EQ(found.value(0, 0), predictor().at({.friction = 0.2}).observables.front().value.value);
    const auto bridges = std::ranges::find(found.observables, dem::Observable::distant_force) -
                         found.observables.begin();
    EXPECT_TRUE(std::isnan(found.value(0, bridges)));
}

TEST(PredictedStates, LeaveOutWhatRunsDoNotSupportAndSayWhy) {
    const std::vector<RequestedState> requested = some_states();
    const PredictedStates found = predict_states(predictor(), requested);
    EXPECT_EQ(found.why_not.back(), "friction 0.95 is above 0.6");
    EXPECT_TRUE(found.value.row(found.value.rows() - 1).array().isNaN().all());
    EXPECT_TRUE(found.slopes.empty());
}

TEST(PredictedStates, LeaveOutNumbersOutOfRangeAndSayWhy) {
    const PredictedStates found = predict_states(
        predictor(), {{.friction = 0.1},
                      {.friction = std::nan("")},
                      {.friction = 0.2},
                      {.friction = 0.2, .reduced_pressure = -1, .liquid_content = 0.01}});
    EXPECT_EQ(found.why_not,
              (std::vector<std::string>{"", "friction nan: 0 to 1 is needed", "",
                                        "reduced pressure -1: a positive number is needed"}));
    for (const int left_out : {1, 3})
        EXPECT_TRUE(found.value.row(left_out).array().isNaN().all());
    for (const int predicted : {0, 2})
        EXPECT_EQ(found.value(predicted, 0), predictor()
                                                 .at({.friction = predicted == 0 ? 0.1 : 0.2})
                                                 .observables.front()
                                                 .value.value);
}

TEST(PredictedStates, RefuseAnAmountOfLiquidWithoutPressure) {
    EXPECT_THROW(predict_states(predictor(), {{.friction = 0.1, .bridge_volume = 0.01}}),
                 InputError);
}

TEST(PredictedStates, AreTheSameFromSeveralThreads) {
    const std::vector<RequestedState> requested(200, {.friction = 0.2});
    std::size_t told = 0;
    const PredictedStates one = predict_states(predictor(), requested),
                          three = predict_states(predictor(), requested,
                                                 {.threads = 3, .report = [&](std::size_t done) {
                                                      told = std::max(told, done);
                                                  }});
    EXPECT_EQ((one.value.array() == three.value.array()).count(),
              (one.value.array() == one.value.array()).count());
    EXPECT_LE(told, requested.size());
}

TEST(PredictedStates, StopOnRequest) {
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(predict_states(predictor(), some_states(), {.stop = stop.get_token()}),
                 dem::Interrupted);
}

}  // namespace pendular::workflow_predicted_states_test
