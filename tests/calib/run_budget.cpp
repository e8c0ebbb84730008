// Runs within a time, and which runs to make in it.
#include "calib/model/run_budget.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "calib/model/informative_runs.h"
#include "data/input_error.h"
#include "sim/dem/simulation_error.h"
#include "sim/runs/store/run_store.h"
#include "tests/support/data_support.h"
#include "tests/support/emulator_support.h"

namespace pendular::calib_run_budget_test {

dem::RunParameters run_of(double strain, std::uint64_t seed = 1) {
    return {.friction = 0.3,
            .inertial_number = 0.03,
            .stiffness_number = 500,
            .grains = 100,
            .strain = strain,
            .seed = seed};
}

TEST(RunBudget, AffordsTheRunsThatEndInItsTime) {
    const std::vector<dem::RunParameters> runs(20, run_of(2));
    dem::RunResult measured{.parameters = run_of(2)};
    measured.wall_seconds = 10;
    EXPECT_EQ(RunBudget().affordable(runs, {measured}, 2), 20u);
    EXPECT_EQ(RunBudget(0).affordable(runs, {measured}, 2), 0u);
    // Nine runs on two threads take 45 s.
    EXPECT_EQ(RunBudget(47).affordable(runs, {measured}, 2), 9u);
    EXPECT_EQ(RunBudget(47).affordable(runs, {measured}, 2, 20), 5u);
    EXPECT_EQ(RunBudget(0).seconds_left(), 0);
    // A third of 47 s suffices for three runs; a third of 13 s for none, but 13 s for two.
    EXPECT_EQ(RunBudget(47).batch(runs, {measured}, 2), 3u);
    EXPECT_EQ(RunBudget(13).batch(runs, {measured}, 2), 2u);
    EXPECT_EQ(RunBudget(3).batch(runs, {measured}, 2), 0u);
    EXPECT_EQ(RunBudget().batch(runs, {measured}, 2), 20u);
}

TEST(RunBudget, HasNoLimitWhereTheTimeHasNone) {
    EXPECT_FALSE(RunBudget(INFINITY).limited());
    EXPECT_FALSE(RunBudget(1e300).limited());
    EXPECT_TRUE(RunBudget(1e6).limited());
    EXPECT_THROW(RunBudget(-1), InputError);
    EXPECT_THROW(RunBudget(NAN), InputError);
}

TEST(RunBudget, KeepsTheRunsThatEndedInItsTime) {
    const TemporaryFolder folder;
    RunStore store(folder.path() / "runs.sqlite");
    const std::vector<dem::RunParameters> runs = {run_of(0.5, 1), run_of(1e4, 2)};
    // The budget follows what the short run takes here, so that a busy or slow machine can end it.
    const double seconds = 2 + 10 * run_all({runs.front()}, {.threads = 1}).front().wall_seconds;
    const auto start = std::chrono::steady_clock::now();
    const auto kept = RunBudget(seconds).run(runs, {.threads = 2, .store = &store});
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    EXPECT_LT(taken.count(), seconds + 60);
    ASSERT_EQ(kept.size(), 1u);
    EXPECT_EQ(kept.front().parameters.seed, 1u);
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(RunBudget(10).run(runs, {.threads = 2, .stop = stop.get_token()}),
                 dem::Interrupted);
}

RunChoice choice_of(const FlowState& target, std::vector<FlowState> from) {
    return {.targets = {target}, .weights = Eigen::Vector2d(1, 1), .from = std::move(from)};
}

TEST(InformativeRuns, AreMadeWithoutAnEffectWhereItIsSmall) {
    const Emulator emulator(all_shipped_runs(), shipped_hyperparameters());
    const Fidelity quick = fidelity_named("quick");
    for (const auto& [coefficient, with_effect] : {std::pair(0.3, true), {1e-4, false}}) {
        const FlowState plain{0.4, 0.01};
        FlowState rolling = plain;
        rolling.effects = {{"rolling-resistance", {coefficient}}};
        // Were the runs equally good, those without the effect would be taken, as they come first.
        const auto chosen = most_informative(emulator, quick, choice_of(rolling, {plain, rolling}));
        ASSERT_EQ(chosen.size(), 4u);
        EXPECT_EQ(!chosen.front().effects.empty(), with_effect) << coefficient;
    }
}

TEST(InformativeRuns, AreAsManyAsTheErrorsNeed) {
    const Emulator emulator(shipped_runs(), shipped_hyperparameters());
    const Fidelity quick = fidelity_named("quick");
    RunChoice choice = choice_of({0.3, 0.01}, {{0.3, 0.01}});
    choice.factor = 1e9;
    EXPECT_EQ(most_informative(emulator, quick, choice).size(), choice.most);
    choice.factor = 1;
    EXPECT_EQ(most_informative(emulator, quick, choice).size(), choice.fewest);
}

TEST(InformativeRuns, ServeNearStatesTogether) {
    FlowState with_it{0.3, 0.01}, with_more = with_it;
    with_it.effects = {{"rolling-resistance", {0.1}}};
    with_more.effects = {{"rolling-resistance", {0.2}}};
    EXPECT_TRUE(near({0.3, 0.01}, {0.301, 0.0102}));
    EXPECT_FALSE(near({0.3, 0.01}, {0.3, 0.012}));
    EXPECT_FALSE(near({0.3, 0.01}, with_it));
    EXPECT_FALSE(near(with_more, with_it));
}

}  // namespace pendular::calib_run_budget_test
