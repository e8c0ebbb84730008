// Which states the known runs support, on the runs that come with the program and on invented ones.
#include "calib/emulator/known_range.h"
#include "calib/emulator/emulated_observables.h"

#include <cmath>
#include <random>

#include "sim/runs/run_request.h"
#include "tests/support/emulator_support.h"
#include "tests/support/golden.h"

namespace pendular::calib_known_range_test {

const Emulator& shipped() {
    static const Emulator emulator(shipped_runs(), shipped_hyperparameters());
    return emulator;
}

TEST(KnownRange, SupportsTheStatesOfAllRunsKnownAndUnseen) {
    const KnownRange known(shipped());
    int states = 0;
    for (const char* file : {"/sim/atlas/atlas.csv", "/tests/data/unseen/runs.csv"}) {
        for (const StoredRun& stored : read_runs(std::string(PENDULAR_SOURCE_DIR) + file)) {
            if (stored.run.parameters.effects.empty() && stored.run.failure.empty()) {
                EXPECT_EQ(known.why_unsupported(emulated::flow_state_of(stored.run.parameters)), "")
                    << run_description(stored.run.parameters);
                ++states;
            }
        }
    }
    EXPECT_GT(states, 500);
}

TEST(KnownRange, SupportsTheQuasiStaticLimitAndWeakCapillarity) {
    const KnownRange known(shipped());
    for (const double friction : {0.0, 0.09, 0.3, 0.6}) {
        EXPECT_EQ(known.why_unsupported({friction, 0}), "") << friction;
        for (const double volume : {0.0005, 0.002, 0.008}) {
            EXPECT_EQ(known.why_unsupported({friction, 0, 1, volume}), "") << friction;
            // Between P* = 50 and dry flow.
            EXPECT_EQ(known.why_unsupported({friction, 0.01, 1e-3, volume}), "") << friction;
        }
    }
}

TEST(KnownRange, NamesWhatLiesBeyondTheRuns) {
    const KnownRange known(shipped());
    expect_told({known.why_unsupported({0.9, 0}), known.why_unsupported({0.3, 0.2}),
                 known.why_unsupported({0.9, 0, 50, 0.026})});
}

TEST(KnownRange, IsConvexNotABox) {
    // Dry runs along a diagonal: fast where there is friction, slow where there is little. A corner
    // lies within the range of each input alone.
    std::vector<dem::RunResult> runs;
    for (const dem::RunResult& run : invented_runs(2000, 4)) {
        const auto& p = run.parameters;
        const double part = p.friction / 0.6;
        if (!p.wetting && std::abs(std::sqrt(p.inertial_number / 0.1) - part) < 0.2) {
            runs.push_back(run);
        }
    }
    ASSERT_GT(runs.size(), 50u);
    const Emulator emulator(runs, shipped_hyperparameters());
    const KnownRange known(emulator);
    const FlowState corner{0.05, 0.08};
    EXPECT_EQ(emulator.beyond(corner), "");
    expect_told({known.why_unsupported(corner)});
    EXPECT_EQ(known.why_unsupported({0.3, 0.025}), "");
    EXPECT_FALSE(known.knows_wet());
    EXPECT_EQ(known.why_unsupported({0.3, 0.025, 1, 0.002}), "no simulation has liquid bridges");
}

TEST(KnownRange, RefusesWhereTheEmulatorIsUnsureBetweenRuns) {
    // Runs without friction and with much of it, and none between; a short length in friction makes
    // the emulator say so.
    std::vector<dem::RunResult> runs;
    for (dem::RunResult run : invented_runs(400, 5)) {
        if (run.parameters.friction < 0.02 || run.parameters.friction > 0.5) {
            run.parameters.wetting.reset();
            runs.push_back(run);
        }
    }
    EmulatorHyperparameters hyperparameters = shipped_hyperparameters();
    for (auto& [which, of] : hyperparameters) {
        of.dry_x = 0.3, of.dry_amplitude = 0.1;
    }
    const Emulator emulator(runs, hyperparameters);
    const KnownRange known(emulator);
    // Between them something is refused for its standard error, and what is answered instead is
    // not.
    int unsure = 0;
    for (const double friction : {0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.35, 0.4, 0.45}) {
        const FlowState between_run_scatter{friction, 0.01};
        const std::string why = known.why_unsupported(between_run_scatter);
        unsure += why.find("standard error") != std::string::npos;
        EXPECT_EQ(known.why_unsupported(known.nearest_supported(between_run_scatter)), "")
            << friction;
    }
    EXPECT_GT(unsure, 0);
}

TEST(KnownRange, FindsASupportedStateNearAnyOther) {
    const KnownRange known(shipped());
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> uniform;
    int outside = 0;
    for (int k = 0; k < 200; ++k) {
        FlowState state{uniform(random), 0.5 * uniform(random)};
        if (k % 2 == 0) {
            state.inverse_pressure = 20 * uniform(random);
            state.bridge_volume = 0.0001 * std::pow(500, uniform(random));
        }
        outside += !known.why_unsupported(state).empty();
        const FlowState near = known.nearest_supported(state);
        EXPECT_EQ(known.why_unsupported(near), "");
        EXPECT_EQ(near.dry(), state.dry());
    }
    EXPECT_GT(outside, 150);
    // One input beyond: the nearest state differs in that alone, and little in the others.
    const FlowState near = known.nearest_supported({0.9, 0.01});
    EXPECT_NEAR(near.friction, 0.6, 0.01);
    EXPECT_NEAR(near.inertial_number, 0.01, 0.001);
}

}  // namespace pendular::calib_known_range_test
