// The comparison with Badetti et al. (2018) rests on the simulations: simulations that differ
// disagree, and states without a simulation are missing.
#include "workflow/reproduction.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim/runs/store/run_table.h"
#include "workflow/study_input.h"

namespace workflow_reproduction_test {

using namespace pendular;
using dem::Observable;

std::vector<dem::RunResult> atlas_runs() {
    std::vector<dem::RunResult> runs;
    for (StoredRun& stored : read_runs(atlas_file())) {
        runs.push_back(std::move(stored.run));
    }
    return runs;
}

const Emulator& emulator() {
    static const Emulator emulator(atlas_runs(), atlas_hyperparameters());
    return emulator;
}

bool agrees(const std::vector<ScoreboardRow>& rows, const std::string& what) {
    const auto row = std::ranges::find(rows, what, &ScoreboardRow::what);
    EXPECT_NE(row, rows.end()) << what;
    return row != rows.end() && row->agrees;
}

std::size_t agreeing(const std::vector<ScoreboardRow>& rows) {
    return static_cast<std::size_t>(std::ranges::count_if(rows, &ScoreboardRow::agrees));
}

TEST(Reproduction, FindsTheNumbersThatTheTextStates) {
    const Reproduction r(fidelity_named("standard"), nullptr);
    EXPECT_GE(r.rows().size(), 60u);
    EXPECT_GE(static_cast<double>(r.agreeing()), 0.77 * static_cast<double>(r.rows().size()));
    for (const char* what :
         {"stress ratio, friction 0.09, I -> 0 [1]", "solid fraction, friction 0.09, I -> 0 [1]",
          "reduced cohesion c*, friction 0.09 [1]",
          "liquid content, V0/a^3 0.004, P* = 3, friction 0.09 [1]",
          "Rumpf's cohesion over c*, friction 0.09, V0/a^3 0.008 [1]"}) {
        EXPECT_TRUE(agrees(r.rows(), what)) << what;
    }
}

TEST(Reproduction, DisagreesWithOtherSimulations) {
    std::vector<dem::RunResult> runs = atlas_runs();
    const std::size_t before = agreeing(compare_with_published(PaperStudy(runs, emulator())));
    for (dem::RunResult& run : runs) {
        if (run.parameters.wetting) {
            run.means[static_cast<std::size_t>(Observable::stress_ratio)].value *= 1.3;
        }
    }
    const auto rows = compare_with_published(PaperStudy(runs, emulator()));
    EXPECT_LE(agreeing(rows) + 15, before);
    EXPECT_FALSE(agrees(
        rows, "contact stress ratio: deviation from the dry one, P* >= 2 [%], friction 0.09"));
}

TEST(Reproduction, FitsTheLineThroughItsStates) {
    // Stress ratios made to lie on mu* = 0.25 + 0.3/P*.
    std::vector<dem::RunResult> runs = atlas_runs();
    for (dem::RunResult& run : runs) {
        if (run.parameters.wetting) {
            run.means[static_cast<std::size_t>(Observable::stress_ratio)].value =
                0.25 + 0.3 / run.parameters.wetting->reduced_pressure;
            run.parameters.stiffness_number = paper_stiffness;
        }
    }
    const PaperStudy study(runs, emulator());
    ASSERT_EQ(study.lines().size(), 25u);
    for (const StrengthLine& line : study.lines()) {
        EXPECT_NEAR(line.intercept.value, 0.25, 1e-9);
        EXPECT_NEAR(line.cohesion.value, 0.3, 1e-9);
        EXPECT_NEAR(line.at(0.5).value, 0.85, 1e-9);
    }
}

TEST(Reproduction, ChangesStatesToTheStiffnessOfThePaper) {
    std::vector<dem::RunResult> soft = atlas_runs();
    std::erase_if(soft,
                  [](const dem::RunResult& run) { return run.parameters.stiffness_number > 2000; });
    const Emulator of_soft(soft, atlas_hyperparameters());
    const PaperStudy all(atlas_runs(), emulator()), changed(soft, emulator()), plain(soft, of_soft);
    EXPECT_GT(all.stiff(), 45u);
    EXPECT_EQ(changed.stiff(), 0u);
    // Simulated at 8400, Z_d of this state is 18 % larger than at 1000.
    const PaperState *simulated = all.at(0.09, 0.0005, 1), *predicted = changed.at(0.09, 0.0005, 1),
                     *unchanged = plain.at(0.09, 0.0005, 1);
    ASSERT_TRUE(simulated && predicted && unchanged);
    const auto distant = [](const PaperState& s) {
        return s[Observable::distant_coordination].value;
    };
    EXPECT_GT(std::abs(distant(*unchanged) / distant(*simulated) - 1), 0.1);
    EXPECT_NEAR(distant(*predicted) / distant(*simulated), 1, 0.03);
}

TEST(Reproduction, OrdersTheStatesThatNoRunSimulates) {
    std::vector<dem::RunResult> runs = atlas_runs();
    std::erase_if(runs, [](const dem::RunResult& run) {
        const auto& wetting = run.parameters.wetting;
        return wetting && run.parameters.friction == 0.15 && wetting->reduced_pressure == 2 &&
               run.parameters.inertial_number == 0.003;
    });
    const PaperStudy study(runs, emulator());
    ASSERT_EQ(study.missing().size(), paper_contents.size());
    for (const MissingState& state : study.missing()) {
        EXPECT_EQ(state.friction, 0.15);
        EXPECT_EQ(state.reduced_pressure, 2);
    }
    EXPECT_EQ(study.at(0.15, 2e-3, 2), nullptr);
}

}  // namespace workflow_reproduction_test
