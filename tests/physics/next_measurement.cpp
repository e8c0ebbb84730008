// A pair that the readings cannot tell apart, the measurement that `next` asks for, and what it
// brings.
#include "analysis/design/next_measurement.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <tuple>

#include "analysis/diagnosis/diagnosis.h"
#include "tests/physics/planted_readings.h"

namespace next_measurement_test {

using namespace pendular;
using testing::Contains;
using testing::IsSupersetOf;
using testing::Not;

std::vector<FittedModel> rivals_of(const Diagnosis& d) {
    std::vector<FittedModel> rivals;
    for (const FittedModel& each : d.confidence_set) {
        rivals.push_back(each);
        rivals.back().name = each.effects.front();
        rivals.back().predictor = models().predictor(each.chosen);
    }
    return rivals;
}

Rig rig() {
    return {.normal_stress = {150, 5000},
            .inertial_number = Span{3e-3, 3e-2},
            .liquid_contents = {0, 0.03},
            .bead_volumes = {20e-3 / 1050, 60e-3 / 1050},
            .repeats = 12};
}

TEST(NextMeasurement, TellsAHeightOffsetFromLostBeads) {
    // The gap shows too small, as it is where beads are lost.
    const Planted planted{"height-offset", -2e-4};
    const std::vector<Reading> before = readings_with(planted, 5);
    const Diagnosis d = diagnose(models(), evidence_of(before, {}));
    ASSERT_EQ(d.verdict, Verdict::indistinguishable);
    ASSERT_THAT(d.effects, Contains("bead-loss"));

    const std::vector<Point> points = points_of(rig(), planted_study(), 1000);
    const auto plans =
        separating_plans(rivals_of(d), points, relative_errors(before), rig().repeats);
    const Plan& plan = plans.front();
    ASSERT_GE(plan.repeats, 1);
    // Another filling: a fixed height is another part of the whole.
    EXPECT_NEAR(*points[plan.point].condition.bead_volume, 20e-3 / 1050, 1e-12);

    // It is measured, and the two are told apart.
    std::vector<Condition> all = conditions();
    all.insert(all.end(), static_cast<std::size_t>(plan.repeats), points[plan.point].condition);
    const StudyModelSpace more = models_of(all);
    const auto truth = more.with(place_of(planted.effect));
    const Eigen::VectorXd values =
        truth->predict(truth_of(planted, *truth), PredictionPart::values).value;
    std::mt19937_64 random(6);
    const std::vector<Condition> fresh(all.begin() + static_cast<std::ptrdiff_t>(before.size()),
                                       all.end());
    std::vector<Reading> readings = before;
    for (Reading& reading :
         scattered(fresh, values.tail(2 * static_cast<Eigen::Index>(fresh.size())), random)) {
        readings.push_back(reading);
    }
    const Diagnosis after = diagnose(more, evidence_of(readings, {}));
    EXPECT_THAT(after.effects, Contains("height-offset"));
    EXPECT_THAT(after.effects, Not(Contains("bead-loss")));
}

TEST(NextMeasurement, TellsADragFromATareByTheEmptyCell) {
    // Over the normal stress both are a constant that is short or over.
    const Planted planted{"torque-offset", 1e-3};
    const std::vector<Reading> readings = readings_with(planted, 5);
    const Diagnosis d = diagnose(models(), evidence_of(readings, {}));
    ASSERT_EQ(d.verdict, Verdict::indistinguishable);
    ASSERT_THAT(d.effects, IsSupersetOf({"torque-offset", "normal-force-offset"}));

    Rig with_empty_cell = rig();
    with_empty_cell.repeats = 3;
    with_empty_cell.direct = {{.effect = "torque-offset", .error = "0.1 mN m", .cost = 0.5}};
    const std::vector<Point> points = points_of(with_empty_cell, planted_study(), 1000);
    const auto plans =
        separating_plans(rivals_of(d), points, relative_errors(readings), with_empty_cell.repeats);
    const Point& chosen = points[plans.front().point];
    ASSERT_TRUE(chosen.direct);
    EXPECT_EQ(chosen.direct->parameter, "torque-offset.torque");

    // The empty cell is turned; of a drag it shows as much as there is, of a tare nothing.
    Study measured = planted_study();
    for (const auto& [value, right, wrong] :
         {std::tuple("1.08 mN m", "torque-offset", "normal-force-offset"),
          std::tuple("-0.06 mN m", "normal-force-offset", "torque-offset")}) {
        measured.direct = {{.effect = "torque-offset", .value = value, .error = "0.1 mN m"}};
        const StudyModelSpace more = models_of(conditions(), measured);
        const Diagnosis after = diagnose(more, evidence_of(readings, {}, more.direct()));
        EXPECT_THAT(after.effects, Contains(right)) << value;
        EXPECT_THAT(after.effects, Not(Contains(wrong))) << value;
    }
}

TEST(NextMeasurement, CannotTellTheAngleFromTheTension) {
    const Diagnosis d =
        diagnose(models(), evidence_of(readings_with({"contact-angle", 0.9}, 5), {}));
    std::vector<FittedModel> rivals;
    for (FittedModel& rival : rivals_of(d)) {
        if (rival.name == "contact-angle" || rival.name == "capillary-bridges") {
            rivals.push_back(rival);
        }
    }
    ASSERT_EQ(rivals.size(), 2u);
    const auto plans = separating_plans(rivals, points_of(rig(), planted_study(), 1000),
                                        Eigen::Vector2d(0.01, 0.002), rig().repeats);
    EXPECT_TRUE(plans.front().separated.empty());
}

}  // namespace next_measurement_test
