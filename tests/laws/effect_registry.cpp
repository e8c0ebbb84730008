// What every effect must say of itself. The names of the tests are the laws.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <variant>

#include "data/quantities/quantity.h"
#include "data/quantities/units.h"
#include "registered_effects.h"
#include "sim/catalogue/effect.h"

namespace effect_registry_test {

using namespace pendular;

class EffectRegistry : public EveryEffect {};

TEST_P(EffectRegistry, NameIsThatOfItsFile) {
    std::string file = effect().name;
    std::ranges::replace(file, '-', '_');
    EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(PENDULAR_SOURCE_DIR) / "sim" /
                                        "effects" / (file + ".cpp")));
}

TEST_P(EffectRegistry, SaysWhatItIsAndWhereItComesFrom) {
    EXPECT_FALSE(effect().summary.empty());
    EXPECT_EQ(effect().summary.find('\n'), std::string::npos);
    EXPECT_FALSE(effect().equation.empty());
    EXPECT_FALSE(effect().references.empty());
}

TEST_P(EffectRegistry, ActsThroughKnownQuantities) {
    EXPECT_FALSE(effect().acts_through.empty());
    for (std::string covariate : effect().acts_through) {
        if (covariate.starts_with("1/")) covariate = covariate.substr(2);
        EXPECT_TRUE(find_quantity(covariate)) << covariate;
    }
}

TEST_P(EffectRegistry, FadesWithCapillarityWhereItChangesBridgesAndNothingElse) {
    const auto* pairs = std::get_if<dem::ChangePairs>(&effect().change);
    const bool on_bridges =
        pairs != nullptr && effect().touches == Touches::wet && pairs->add == nullptr;
    EXPECT_EQ(effect().fades_with_capillarity, on_bridges);
}

// A change that is proportional to 1/P* is largest at small P*, and the pages on effects say so.
TEST_P(EffectRegistry, NamesThePressureAtWhichACapillaryEffectIsLargest) {
    if (!effect().fades_with_capillarity) return;
    EXPECT_NE(std::ranges::find(effect().acts_through, "1/reduced_pressure"),
              effect().acts_through.end());
}

TEST_P(EffectRegistry, HasParametersWithUnits) {
    ASSERT_FALSE(effect().parameters.empty());
    for (const EffectParameter& p : effect().parameters) {
        EXPECT_FALSE(p.name.empty());
        EXPECT_FALSE(p.meaning.empty()) << p.name;
        EXPECT_NO_THROW(Unit(p.unit)) << p.unit;
        // Values are SI: one of the unit is 1.
        EXPECT_EQ(Unit(p.unit).to_si(1), 1) << p.unit;
    }
}

TEST_P(EffectRegistry, IsNeutralWithinItsBounds) {
    for (const EffectParameter& p : effect().parameters) {
        EXPECT_LT(p.lower, p.upper) << p.name;
        EXPECT_LE(p.lower, p.neutral) << p.name;
        EXPECT_LE(p.neutral, p.upper) << p.name;
    }
}

TEST_P(EffectRegistry, HasASizeThatMattersWithinItsBounds) {
    for (const EffectParameter& p : effect().parameters) {
        EXPECT_GT(p.smallest_of_interest, 0) << p.name;
        EXPECT_LE(p.neutral + p.smallest_of_interest, p.upper) << p.name;
        // An effect of one sign has its lower bound at neutral.
        if (p.lower < p.neutral) {
            EXPECT_LE(p.lower, p.neutral - p.smallest_of_interest) << p.name;
        }
    }
}

TEST_P(EffectRegistry, HasAnAmplitudeThatVanishesAtNeutralAndGrows) {
    for (const EffectParameter& p : effect().parameters) {
        if (!p.amplitude) continue;
        EXPECT_EQ(p.amplitude(p.neutral), 0) << p.name;
        EXPECT_GT(p.amplitude(p.neutral + p.smallest_of_interest), 0) << p.name;
    }
}

TEST_P(EffectRegistry, IsFeltFromNeutralOnAndMostAtItsUpperBound) {
    for (const EffectParameter& p : effect().parameters) {
        if (!p.effective_amplitude) continue;
        for (const double friction : {0.02, 0.1, 0.5}) {
            EXPECT_EQ(p.effective_amplitude(p.neutral, friction), 0) << p.name;
            EXPECT_GT(p.effective_amplitude(p.neutral + p.smallest_of_interest, friction), 0)
                << p.name;
            EXPECT_GE(p.effective_amplitude(p.upper, friction),
                      p.effective_amplitude((p.neutral + p.upper) / 2, friction));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Effects, EffectRegistry,
                         testing::ValuesIn(names_of_effects([](const Effect&) { return true; })),
                         test_name);

}  // namespace effect_registry_test
