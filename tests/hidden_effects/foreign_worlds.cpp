// Diagnoses of grains that LAMMPS simulated: contacts, integration and control of the height are
// not those of the code that the emulator learnt from. States are in
// bench/foreign_worlds/states.csv; each study has noise of its own, with fixed seeds.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <stdexcept>

#include "bench/hidden_effects/foreign_world.h"
#include "bench/hidden_effects/walk.h"
#include "tests/support/app_support.h"

namespace foreign_worlds_test {

using namespace pendular;
using bench::ForeignWorld;

constexpr int studies = 20;

const ForeignWorld& world_named(const std::string& name) {
    static const std::vector<ForeignWorld> all = bench::read_foreign_worlds(
        std::filesystem::path(PENDULAR_SOURCE_DIR) / "bench/foreign_worlds/states.csv");
    const auto found =
        std::ranges::find(all, name, [](const ForeignWorld& world) { return world.truth.name; });
    if (found == all.end()) throw std::runtime_error("states of world '" + name + "' are missing");
    return *found;
}

struct Counts {
    int alarms = 0, right = 0, wrong = 0;
};

Counts diagnosed(const std::string& name, const std::array<double, 2>& discrepancy) {
    const ForeignWorld& world = world_named(name);
    std::vector<std::string> hidden;
    for (const ActiveEffect& active : world.truth.hidden) {
        hidden.push_back(active.effect->name);
    }
    Counts counts;
    const TemporaryFolder folder;
    for (int study = 0; study < studies; ++study) {
        const bench::Outcome outcome =
            bench::walk(world.truth, world.laboratory, study, folder.path() / "study", discrepancy);
        counts.alarms += outcome.verdict != "nothing-missing" && outcome.verdict != "inconclusive";
        const bool names = outcome.verdict == "missing", right = outcome.named == hidden;
        counts.right += names && right;
        counts.wrong += names && !right;
    }
    std::printf("%s: %d alarms in %d studies, the hidden effect named in %d, another in %d\n",
                name.c_str(), counts.alarms, studies, counts.right, counts.wrong);
    return counts;
}

/// Half a per cent of the stress ratio and 0.1 % of the solid fraction.
constexpr std::array<double, 2> stated = {0.005, 0.001};

class Complete : public testing::TestWithParam<const char*> {};

// One study in twenty may be called incomplete; at most four are, with a probability of 99.7 %.
TEST_P(Complete, RaisesNoAlarmWhereTheErrorOfTheModelIsStated) {
    EXPECT_LE(diagnosed(GetParam(), stated).alarms, 4);
}

std::string name_of(const testing::TestParamInfo<const char*>& info) {
    return std::string(info.param).substr(0, 3);  // dry, wet
}

INSTANTIATE_TEST_SUITE_P(ForeignWorlds, Complete, testing::Values("dry plain", "wet plain"),
                         name_of);

// Nine in ten are wanted: fewer than 15 of 20 are then named with a probability of 1.1 %. One wrong
// name in fifty is allowed: there are then more than two with a probability of 0.7 %.
TEST(ForeignWorlds, RollingResistanceIsNamed) {
    const Counts counts = diagnosed("dry rolling", stated);
    EXPECT_GE(counts.right, 15);
    EXPECT_LE(counts.wrong, 2);
}

}  // namespace foreign_worlds_test
