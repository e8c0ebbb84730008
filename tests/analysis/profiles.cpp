// Profiles of changes of unknown cause, and their formulas.
#include "analysis/proposals/profile.h"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/proposals/shape.h"
#include "sim/catalogue/formula.h"
#include "tests/support/effect_study.h"

namespace pendular {
namespace {

/// Readings at the conditions of the virtual laboratory, without errors.
std::vector<Reading> laboratory_readings() {
    std::vector<Reading> readings;
    for (const Condition& condition : conditions()) {
        Reading reading{.condition = condition};
        reading.value = {0.3 * condition.normal_stress, 0.6};
        readings.push_back(reading);
    }
    return readings;
}

TEST(Profiles, AreAlongEveryQuantityThatVaries) {
    std::vector<std::string> names;
    for (const bool of_instrument : {false, true}) {
        for (const auto& each :
             coordinates_of(laboratory_readings(), study_with("dem"), of_instrument)) {
            names.push_back(each.variable);
        }
    }
    EXPECT_EQ(names, (std::vector<std::string>{"normal_stress", "inertial_number", "liquid_content",
                                               "time", "normal_stress", "angular_velocity",
                                               "liquid_content", "time"}));
}

TEST(Profiles, EqualTheirFormulasAndAreAtMostOne) {
    for (const auto& coordinate : coordinates_of(laboratory_readings(), study_with("dem"), true)) {
        const auto profiles = profiles_along(coordinate, true);
        EXPECT_GT(profiles.size(), 10u);
        for (const Profile& profile : profiles) {
            const CompiledFormula formula(profile.formula(), {coordinate.variable});
            double largest = 0;
            for (Eigen::Index k = 0; k < coordinate.at.size(); ++k) {
                const double x = coordinate.at(k);
                EXPECT_NEAR(formula({&x, 1}), profile.at(k), 2e-4) << profile.formula();
                largest = std::max(largest, std::abs(profile.at(k)));
            }
            EXPECT_LE(largest, 1 + 1e-9) << profile.formula();
            EXPECT_GT(largest, 0.05) << profile.formula();
        }
    }
}

TEST(Profiles, AreFiniteWhereAQuantityIsPresentOrAbsent) {
    const ReadingCoordinate one_content{"liquid_content", "1", Eigen::Vector4d(0, 0, 0.03, 0.03)};
    const auto profiles = profiles_along(one_content, false);
    EXPECT_FALSE(profiles.empty());
    for (const Profile& profile : profiles) {
        EXPECT_TRUE(profile.at.allFinite()) << profile.formula();
    }
}

TEST(Profiles, StepBetweenAllReadingsOfALongSeries) {
    const ReadingCoordinate times{"time", "s", Eigen::VectorXd::LinSpaced(300, 0, 2990)};
    double latest = 0;
    for (const Profile& profile : profiles_along(times, false)) {
        if (profile.dependence == Dependence::above) latest = std::max(latest, profile.constant);
    }
    EXPECT_GT(latest, 2900);
}

TEST(Profiles, ReachOneWhereTheySay) {
    for (const auto& coordinate : coordinates_of(laboratory_readings(), study_with("dem"), true)) {
        for (const Profile& profile : profiles_along(coordinate, true)) {
            if (profile.full_at == 0) continue;
            const CompiledFormula formula(profile.formula(), {coordinate.variable});
            EXPECT_NEAR(formula({&profile.full_at, 1}), 1, 1e-4) << profile.formula();
        }
    }
}

TEST(Shapes, ChangeOnlyWhatTheStudyHas) {
    Study dry = study_with("dem");
    dry.sources = {{.liquid_content = 0.0}};
    std::vector<std::string> names;
    for (const auto& quantity : quantities_that_may_change(dry, laboratory_readings())) {
        names.push_back(quantity.target);
    }
    EXPECT_EQ(names, (std::vector<std::string>{"torque", "torque", "normal_force", "normal_force",
                                               "height", "stress_ratio", "solid_fraction",
                                               "friction_difference"}));
    dry.cell.reset();
    EXPECT_EQ(quantities_that_may_change(dry, laboratory_readings()).size(), 3u);
}

}  // namespace
}  // namespace pendular
