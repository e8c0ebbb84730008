// Impacts on straight lines, where the shift by an effect is known in closed form.
#include "analysis/diagnosis/impact.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/line_study.h"

using namespace pendular;
using ::testing::ElementsAre;

namespace {

const Impact& impact_of(const ImpactTable& table, const std::string& name) {
    const auto found = std::ranges::find(table.impacts, name, &Impact::name);
    EXPECT_NE(found, table.impacts.end()) << name;
    return *found;
}

Diagnosis diagnosed(const LinearSpace& space, const Evidence& evidence) {
    return diagnose(space, evidence, quickly());
}

}  // namespace

TEST(Impact, IsTheClosedFormForALine) {
    const LinearSpace space = line_and();
    Measuring measuring(1);
    const Evidence evidence = measuring.of(plain());
    const ImpactTable table = impacts(space, evidence, diagnosed(space, evidence));
    // Least squares of -x^2 on 1 and x over places that are symmetric about 0: the intercept is
    // minus the mean of x^2, (n + 1)/(3 (n - 1)) for n equidistant places from -1 to 1; the slope
    // is 0.
    const Shift& shift = impact_of(table, "parabola").at_interest;
    EXPECT_EQ(shift.size, 1);
    EXPECT_NEAR(shift.linear(0), -(line_conditions + 1) / (3.0 * (line_conditions - 1)), 1e-9);
    EXPECT_NEAR(shift.linear(1), 0, 1e-9);
}

TEST(Impact, OfARefitIsTheLinearOneForALine) {
    const LinearSpace space = line_and();
    Measuring measuring(2);
    const Evidence evidence =
        measuring.of(plain() + 5 * over_places([](double x) { return x * x; }));
    const Diagnosis d = diagnosed(space, evidence);
    ASSERT_THAT(d.effects, ElementsAre("parabola"));
    const ImpactTable table = impacts(space, evidence, d);
    // The effect of the verdict comes first, and its estimate is that of the refit.
    const Impact& first = table.impacts.front();
    EXPECT_EQ(first.name, "parabola");
    const Fit& refit = d.confidence_set.front().fit;
    EXPECT_NEAR(first.at_estimate.size, refit.parameters(2), 1e-6);
    EXPECT_NEAR(first.at_estimate.refitted(0), refit.parameters(0) - d.base.fit.parameters(0),
                1e-6);
    EXPECT_NEAR(first.pull(), refit.parameters(2) / refit.standard_error(2), 1e-6);
    std::size_t refitted = 0;
    for (const Impact& impact : table.impacts) {
        for (const Shift* shift :
             {&impact.at_interest, &impact.at_estimate, &impact.above, &impact.below}) {
            if (shift->refitted.size() == 0) continue;
            ++refitted;
            EXPECT_NEAR((shift->refitted - shift->linear).norm(), 0, 1e-6) << impact.name;
        }
    }
    EXPECT_EQ(refitted, 4 + 3 * 2);  // the named effect at four sizes, three more at two
}

TEST(Impact, OfAnErrorIsOneStandardErrorOfTheSizeToBothSides) {
    const LinearSpace space = line_and();
    Measuring measuring(3);
    const Evidence evidence = measuring.of(plain());
    const ImpactTable table = impacts(space, evidence, diagnosed(space, evidence));
    const Impact& parabola = impact_of(table, "parabola");
    // Fitting the parabola too adds the square of this shift to the variance of the intercept.
    const Fit with = fit(*space.with({0}), evidence.measured, start_of(*space.with({0})));
    const Fit without = fit(*space.with({}), evidence.measured, start_of(*space.with({})));
    EXPECT_NEAR(parabola.up()(0), -parabola.down()(0), 1e-6);
    EXPECT_NEAR(std::pow(parabola.by_error()(0), 2),
                with.covariance(0, 0) - without.covariance(0, 0), 1e-6);
}

TEST(Impact, HasNoPullWhereNoFitSettlesTheSize) {
    const LinearSpace space = line_and();
    Measuring measuring(2);
    const Evidence evidence =
        measuring.of(plain() + 5 * over_places([](double x) { return x * x; }));
    Diagnosis d = diagnosed(space, evidence);
    ASSERT_TRUE(std::isfinite(impact_of(impacts(space, evidence, d), "parabola").pull()));
    for (FittedModel& each : d.tried) {
        each.fit.converged = false;
    }
    EXPECT_TRUE(std::isnan(impact_of(impacts(space, evidence, d), "parabola").pull()));
}

TEST(Impact, OfASuspectConditionIsThatOfCorrectingItsReadings) {
    const LinearSpace space = line_and();
    Measuring measuring(4);
    const Evidence evidence = measuring.of(plain());
    const ImpactTable table = impacts(space, evidence, diagnosed(space, evidence));
    // In the middle of the line, both readings of a condition too high by 1 raise the intercept by
    // 1 over the number of conditions.
    const Impact& middle = impact_of(table, "condition 7");
    EXPECT_TRUE(middle.measurement);
    EXPECT_NEAR(middle.at_interest.linear(0), -1.0 / line_conditions, 1e-9);
}

TEST(Impact, LeavesNoParameterBeyondItsBounds) {
    const LinearSpace space =
        line_and({column("huge", [](double x) { return 1e9 * (1 + 1e-6 * x * x); })});
    Measuring measuring(7);
    const Evidence evidence = measuring.of(plain());
    const Diagnosis d = diagnosed(space, evidence);
    const ImpactTable table = impacts(space, evidence, d);
    const Shift& shift = impact_of(table, "huge").at_interest;
    const double lower = space.with({})->bounds().lower(0);
    EXPECT_NEAR(d.base.fit.parameters(0) + shift.best()(0), lower, 1e-6 * std::abs(lower));
    EXPECT_LT(d.base.fit.parameters(0) + shift.linear(0), 10 * lower);
}

TEST(Impact, OfAGroupIsTheRootOfTheSumOfSquares) {
    const LinearSpace space = line_and();
    Measuring measuring(5);
    const Evidence evidence = measuring.of(plain());
    const ImpactTable table = impacts(space, evidence, diagnosed(space, evidence));
    ASSERT_EQ(table.groups.size(), 1u);  // no part of this space has a group of its own
    Eigen::VectorXd squares = Eigen::VectorXd::Zero(2);
    for (const Impact& impact : table.impacts) {
        squares += impact.at_interest.linear.cwiseAbs2();
    }
    EXPECT_NEAR((table.groups.front().at_interest - squares.cwiseSqrt()).norm(), 0, 1e-12);
}

TEST(Impact, OfASwitchIsThatOfSwitchingItOn) {
    LinearSpace::Column on = column("on", [](double x) { return 2 + x; });
    on.parameter = on_switch("it is on");
    const LinearSpace space = line_and({on});
    Measuring measuring(6);
    const Evidence evidence = measuring.of(plain());
    const ImpactTable table = impacts(space, evidence, diagnosed(space, evidence));
    const Impact& impact = impact_of(table, "on");
    EXPECT_NEAR(impact.at_interest.linear(0), -2, 1e-9);
    EXPECT_NEAR(impact.at_interest.linear(1), -1, 1e-9);
}
