#include <gtest/gtest.h>

#include "calib/emulator/emulated_observables.h"
#include "sim/runs/run_settings.h"
#include "tests/support/emulator_support.h"
#include "workflow/study_input.h"

namespace pendular::app_known_runs_test {

TEST(KnownRuns, AreTheAtlasAndTheLatestOfTheStore) {
    RunStore store(RunStore::in_memory);
    auto own = invented_runs(1200, 40);
    for (std::size_t k = 0; k < own.size(); ++k) {
        own[k].strain_transient = static_cast<double>(k);  // tells their order
        store.add(own[k]);
    }
    const Study study{};
    const Fidelity quick = fidelity_named("quick");
    const auto known = known_runs(study, quick, &store);
    ASSERT_TRUE(known);
    const std::size_t shipped = shipped_runs().size();
    ASSERT_EQ(known->runs.size(), most_known);
    EXPECT_EQ(known->runs[shipped].strain_transient, 1199);
    EXPECT_EQ(known->runs.back().strain_transient,
              1200 - static_cast<double>(most_known - shipped));
    EXPECT_EQ(known_runs(study, quick, nullptr)->runs.size(), shipped);
    EXPECT_EQ(known->hyperparameters.size(), emulated::observables().size());
}

TEST(KnownRuns, CountARunOnceThatIsInBoth) {
    RunStore store(RunStore::in_memory);
    for (const auto& run : shipped_runs()) {
        store.add(run);
    }
    EXPECT_EQ(known_runs(Study{}, fidelity_named("quick"), &store)->runs.size(),
              shipped_runs().size());
}

}  // namespace pendular::app_known_runs_test
