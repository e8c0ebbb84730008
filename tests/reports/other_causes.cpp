// Sentences on other causes that the readings leave open.
#include "reports/other_causes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace other_causes_test {

using namespace pendular;

/// Wet readings of these contents, one after the other, after a dry one.
std::vector<Reading> measured(const std::vector<double>& contents) {
    std::vector<Reading> readings(1);
    for (const double content : contents) {
        Reading reading;
        reading.condition.liquid_content = content;
        reading.condition.time = 100.0 * static_cast<double>(readings.size());
        readings.push_back(reading);
    }
    return readings;
}

TEST(OrderOfContents, CountsPairsOfWetReadings) {
    EXPECT_EQ(order_of_contents(measured({0.006, 0.006, 0.014, 0.03})), 1);
    EXPECT_EQ(order_of_contents(measured({0.03, 0.014, 0.006})), -1);
    EXPECT_NEAR(order_of_contents(measured({0.014, 0.03, 0.006})), -1.0 / 3, 1e-12);
    EXPECT_EQ(order_of_contents(measured({0.006, 0.006})), 0);
    EXPECT_EQ(order_of_contents(measured({})), 0);
}

TEST(OrderOfContents, MattersWhereAnEffectThatChangesWithTimeIsNamed) {
    const EffectCatalogue catalogue;
    StudyDiagnosis diagnosis;
    diagnosis.readings = measured({0.006, 0.014, 0.03});
    diagnosis.diagnosis.verdict = Verdict::missing;
    diagnosis.diagnosis.effects = {"viscous-bridges", "liquid-loss"};
    EXPECT_THAT(order_line(diagnosis, catalogue),
                testing::StartsWith("liquid-loss changes with time, and the liquid contents were "
                                    "measured in increasing order"));
    diagnosis.diagnosis.effects = {"viscous-bridges"};
    EXPECT_EQ(order_line(diagnosis, catalogue), "");
    diagnosis.diagnosis.effects = {"liquid-loss"};
    diagnosis.diagnosis.verdict = Verdict::inconclusive;
    EXPECT_EQ(order_line(diagnosis, catalogue), "");
    diagnosis.diagnosis.verdict = Verdict::missing;
    diagnosis.readings = measured({0.014, 0.03, 0.006});
    EXPECT_EQ(order_line(diagnosis, catalogue), "");
}

TEST(DirectMethods, AreThoseOfTheEffectsThatHaveOne) {
    const EffectCatalogue catalogue;
    const std::vector<std::string> effects = {"willett-bridges", "capillary-bridges",
                                              "polydispersity"};
    EXPECT_EQ(direct_methods(effects, catalogue),
              "capillary-bridges by a tensiometer; polydispersity by sieving");
    EXPECT_EQ(direct_methods({"willett-bridges"}, catalogue), "");
}

TEST(RivalsLine, NamesTheModelsThatTheReadingsDoNotRuleOut) {
    const EffectCatalogue catalogue;
    FittedModel rival{.name = "contact-angle in place of torque-gain",
                      .effects = {"contact-angle"},
                      .in_place_of = "torque-gain"};
    rival.fit.chi2 = 12.345;
    EXPECT_THAT(
        rivals_line({rival}, 11, catalogue),
        testing::StartsWith("The readings do not rule out these other models: contact-angle "
                            "in place of torque-gain (chi2 12.35). The chi2 of the present "
                            "model is 11.00."));
    EXPECT_EQ(rivals_line({}, 11, catalogue), "");
}

}  // namespace other_causes_test
