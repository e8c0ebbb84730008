// Set points of the rheometer at which grains are sheared at a condition.
#include "data/study/study.h"

#include <gtest/gtest.h>

#include "data/grains.h"

namespace set_point_test {

using namespace pendular;

Study study() {
    Study study;
    study.grains = {.diameter = 500e-6, .density = 1050};
    study.cell = AnnularCell{.inner_radius = 0.02, .outer_radius = 0.045, .bead_volume = 57e-6};
    return study;
}

TEST(SetPoint, GivesTheConditionBack) {
    const Condition condition{.normal_stress = 300, .inertial_number = 0.01};
    const SetPoint set = set_point_of(condition, study()).value();
    const AnnularCell cell = *study().cell;
    EXPECT_NEAR(normal_stress(set.normal_force, cell), 300, 1e-9);
    EXPECT_NEAR(shear_rate(set.angular_velocity, height(0.6, cell), cell),
                shear_rate_at(0.01, 300, study().grains), 1e-9);
}

TEST(SetPoint, TurnsTheLidOfATallerSampleFaster) {
    Condition condition{.normal_stress = 300, .inertial_number = 0.01};
    const double low = set_point_of(condition, study())->angular_velocity;
    condition.bead_volume = 2 * 57e-6;
    EXPECT_NEAR(set_point_of(condition, study())->angular_velocity, 2 * low, 1e-12);
}

TEST(SetPoint, NeedsACell) {
    Study without = study();
    without.cell.reset();
    EXPECT_FALSE(set_point_of({.normal_stress = 300, .inertial_number = 0.01}, without));
}

}  // namespace set_point_test
