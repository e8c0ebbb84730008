#include "sim/runs/campaign.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "sim/runs/ensemble.h"
#include "sim/runs/run_request.h"
#include "tests/support/golden.h"

namespace pendular::sim_campaign_test {

std::vector<dem::RunParameters> runs_of(const std::string& text) {
    const TemporaryFolder folder;
    return read_campaign(folder.write("runs.toml", text), fidelity_named("standard"));
}

std::string refusal(const std::string& text) {
    try {
        runs_of(text);
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

TEST(Campaign, MakesGridsListsAndRepeats) {
    const auto runs = runs_of(
        "[[grid]]\nfriction = [0.1, 0.2, 0.3]\ninertial_number = [0.01, 0.1]\nrepeats = 2\n"
        "[[list]]\nfriction = [0.4, 0.5]\nreduced_pressure = [1, 2]\nbridge_volume = 0.004\n");
    ASSERT_EQ(runs.size(), 14u);
    std::set<std::uint64_t> seeds;
    for (const auto& run : runs) {
        EXPECT_TRUE(seeds.insert(run.seed).second);
    }
    EXPECT_FALSE(runs[0].wetting);
    EXPECT_EQ(runs[13].friction, 0.5);
    EXPECT_EQ(runs[13].wetting->reduced_pressure, 2);
    EXPECT_EQ(runs[13].wetting->bridge_volume, 0.004);
}

TEST(Campaign, FillsItsRangesEvenly) {
    const auto runs = runs_of(
        "[[sobol]]\npoints = 256\nfriction = [0, 0.6]\ninertial_number = [0.001, 0.1]\n"
        "logarithmic = [\"inertial_number\"]\nbeads = 100\n");
    ASSERT_EQ(runs.size(), 256u);
    // Every cell of an 8 x 8 grid holds 4 of them: a random filling leaves one empty in 50.
    int counts[8][8] = {};
    for (const auto& run : runs) {
        EXPECT_EQ(run.grains, 100);
        const double along = run.friction / 0.6, up = std::log10(run.inertial_number / 0.001) / 2;
        ++counts[std::min(7, static_cast<int>(8 * along))][std::min(7, static_cast<int>(8 * up))];
    }
    for (const auto& row : counts) {
        for (const int count : row) {
            EXPECT_NEAR(count, 4, 2);
        }
    }
}

TEST(Campaign, KeepsTheSeedsOfAShorterOne) {
    const auto few = runs_of("[[grid]]\nfriction = [0.2]\n");
    const auto more = runs_of("[[grid]]\nfriction = [0.1, 0.2, 0.3]\nrepeats = 2\n");
    EXPECT_EQ(run_description(few[0]), run_description(more[2]));
    EXPECT_NE(runs_of("seed = 2\n[[grid]]\nfriction = 0.2\n")[0].seed, few[0].seed);
    // What two tables ask for is done once.
    EXPECT_EQ(runs_of("[[grid]]\nfriction = 0.2\n[[list]]\nfriction = [0.2, 0.3]\n").size(), 2u);
}

TEST(Campaign, IsSharedOutByCost) {
    const auto runs = runs_of(
        "[[grid]]\nfriction = [0, 0.1]\ninertial_number = [0.001, 0.002, "
        "0.004, 0.008, 0.016]\n");
    std::set<std::string> all;
    double least = INFINITY, greatest = 0;
    for (int share = 1; share <= 2; ++share) {
        double cost = 0;
        for (const auto& run : share_of(runs, share, 2)) {
            EXPECT_TRUE(all.insert(run_description(run)).second);
            cost += expected_cost(run);
        }
        least = std::min(least, cost), greatest = std::max(greatest, cost);
    }
    EXPECT_EQ(all.size(), runs.size());
    EXPECT_LT(greatest, 1.5 * least);
}

TEST(Campaign, PointsToWhatIsWrong) {
    expect_told({refusal("[[grid]]\nfrction = 0.1\n"), refusal("[[grid]]\nfriction = -0.1\n"),
                 refusal("[[grid]]\nfriction = [0.1, \"a\"]\n"),
                 refusal("[[grid]]\nbridge_volume = 0.1\n"), refusal("[[grid]]\nbeads = [100.5]\n"),
                 refusal("[[list]]\nfriction = [0.1, 0.2]\nbeads = [64, 65, 66]\n"),
                 refusal("[[sobol]]\npoints = 4\nfriction = 0.1\n"),
                 refusal("[[sobol]]\npoints = 4\nfriction = [0, 0.1]\nlogarithmic = "
                         "[\"friction\"]\n"),
                 refusal("[[sobol]]\nfriction = [0, 0.1]\n"), refusal("seed = 3\n"),
                 refusal("[[grid]]\nfriction = \n"), refusal("[[grid]]\nrepeats = 1.5\n")});
}

TEST(Campaign, HasEffectsOnGrains) {
    const auto grid = runs_of(
        "[[grid]]\nfriction = [0.1, 0.2]\nrolling-resistance.coefficient = [0, 0.05, 0.2]\n");
    ASSERT_EQ(grid.size(), 6u);
    std::set<std::string> keys;
    std::set<std::uint64_t> seeds;
    for (const auto& run : grid) {
        EXPECT_TRUE(keys.insert(run_description(run)).second);
        EXPECT_TRUE(seeds.insert(run.seed).second);
    }
    const auto with = [](const dem::RunParameters& run, double coefficient) {
        return run.effects == std::vector<EffectValues>{{"rolling-resistance", {coefficient}}};
    };
    // A neutral one is none: the same run as in a file that knows no effects.
    const auto none = std::ranges::find_if(
        grid, [](const auto& run) { return run.effects.empty() && run.friction == 0.1; });
    ASSERT_NE(none, grid.end());
    EXPECT_EQ(run_description(*none), run_description(runs_of("[[grid]]\nfriction = 0.1\n")[0]));
    EXPECT_EQ(std::ranges::count_if(grid, [&](const auto& run) { return with(run, 0.2); }), 2);

    const auto list = runs_of(
        "[[list]]\nreduced_pressure = 2\nbridge_volume = 0.002\nviscous-bridges.viscosity = [0.1, "
        "0.3]\n"
        "willett-bridges.on = [0, 1]\n");
    ASSERT_EQ(list.size(), 2u);
    // In the units of a run, as they stand; by name.
    EXPECT_EQ(list[0].effects, (std::vector<EffectValues>{{"viscous-bridges", {0.1}}}));
    EXPECT_EQ(list[1].effects,
              (std::vector<EffectValues>{{"viscous-bridges", {0.3}}, {"willett-bridges", {1}}}));

    const auto sobol = runs_of(
        "[[sobol]]\npoints = 16\npolydispersity.deviation = [0.05, 0.25]\n"
        "dry-adhesion.force = [0.001, 0.1]\nlogarithmic = [\"dry-adhesion.force\"]\n");
    ASSERT_EQ(sobol.size(), 16u);
    int weak = 0;
    for (const auto& run : sobol) {
        ASSERT_EQ(run.effects.size(), 2u);
        const double force = run.effects[0].values[0], deviation = run.effects[1].values[0];
        EXPECT_TRUE(force >= 0.001 && force <= 0.1 && deviation >= 0.05 && deviation <= 0.25);
        weak += force < 0.01;
    }
    EXPECT_NEAR(weak, 8, 1);  // the middle of a logarithmic range
}

TEST(Campaign, PointsToWhatIsWrongWithItsEffects) {
    const auto refused = [](const std::string& line) {
        return refusal("seed = 1\n\n[[grid]]\nfriction = 0.1\n" + line + "\n");
    };
    expect_told({refused("rolling-resistance.coeficient = 0.1"),
                 refused("rolling-resistence.coefficient = 0.1"),
                 refused("rolling-resistance.coefficient = [0.1, 0.9]"),
                 refused("willett-bridges.on = 1"),
                 refused("reduced_pressure = 2\nbridge_volume = 0.002\nwillett-bridges.on = 0.5"),
                 refused("torque-offset.torque = 0.1")});
}

}  // namespace pendular::sim_campaign_test
