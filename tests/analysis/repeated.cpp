// Repetitions of experiments about straight lines, where linearised models are exact. Rates are
// held to what binomial scatter allows: seeds are fixed, ranges hold 99 %.
#include "analysis/diagnosis/repeated.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "analysis/diagnosis/linearised_space.h"
#include "tests/support/line_study.h"

using namespace pendular;
using ::testing::ElementsAre;

namespace {

constexpr std::size_t repetitions = 300;

/// Wave that the score test sees with this noncentrality.
Eigen::VectorXd wave_of(double noncentrality) {
    const Eigen::VectorXd wave =
        over_places([](double x) { return std::sin(3 * std::numbers::pi * x); });
    return std::sqrt(noncentrality / wave.squaredNorm()) * wave;
}

/// Diagnosis of readings without any error, so that its estimates are the truth.
struct Truth {
    Evidence evidence;
    Diagnosis diagnosis;
};

Truth truth_of(const LinearSpace& space, const Eigen::VectorXd& values) {
    Truth truth{Measuring(1).of(values), {}};
    truth.evidence.measured.value = values;
    truth.diagnosis = diagnose(space, truth.evidence, quickly());
    return truth;
}

/// Share of independent experiments about `values` with the verdict of `truth`.
double true_share(const LinearSpace& space, const Diagnosis& truth, const Eigen::VectorXd& values) {
    Measuring measuring(17);
    std::size_t same = 0;
    for (std::size_t k = 0; k < repetitions; ++k) {
        same +=
            confirms_verdict(truth, diagnose(space, measuring.of(values), quickly(k + 1))) ? 1 : 0;
    }
    return static_cast<double>(same) / repetitions;
}

double share(const std::optional<Repeated>& repeated) {
    return static_cast<double>(repeated->same) / static_cast<double>(repeated->of);
}

/// Largest difference of two shares of `repetitions` each that binomial scatter explains (99 %).
double scatter(double share) {
    return 2.58 * std::sqrt(2 * share * (1 - share) / repetitions);
}

}  // namespace

class RepeatedWave : public ::testing::TestWithParam<double> {};

TEST_P(RepeatedWave, ComesAgainAsOftenAsStated) {
    const LinearSpace space = line_and();
    const Eigen::VectorXd values = plain() + wave_of(GetParam());
    const Truth truth = truth_of(space, values);
    ASSERT_THAT(truth.diagnosis.effects, ElementsAre("wave"));
    const auto stated = repeat(space, truth.evidence, truth.diagnosis,
                               {.count = repetitions, .draws = 1000, .seed = 5});
    ASSERT_TRUE(stated);
    EXPECT_EQ(stated->of, repetitions);
    const double expected = true_share(space, truth.diagnosis, values);
    EXPECT_NEAR(share(stated), expected, scatter(expected));
}

// Noncentralities with which the verdict comes again in half and in nine tenths of the experiments.
INSTANTIATE_TEST_SUITE_P(Noncentralities, RepeatedWave, ::testing::Values(14.0, 40.0));

TEST(Repeated, CompleteModelsAreCalledIncompleteAtTheStatedRate) {
    const LinearSpace space = line_and();
    const Truth truth = truth_of(space, plain());
    const auto stated = repeat(space, truth.evidence, truth.diagnosis,
                               {.count = repetitions, .draws = 1000, .seed = 6});
    const double expected = true_share(space, truth.diagnosis, plain());
    EXPECT_GT(share(stated), 0.9);  // 0.95 by the limits
    EXPECT_NEAR(share(stated), expected, scatter(expected));
}

TEST(Repeated, StrongEffectsComeAgainAndWeakOnesNot) {
    const LinearSpace space = line_and();
    const auto share_of = [&](double noncentrality) {
        const Truth truth = truth_of(space, plain() + wave_of(noncentrality));
        return share(repeat(space, truth.evidence, truth.diagnosis,
                            {.count = 100, .draws = 500, .seed = 2}));
    };
    EXPECT_GT(share_of(100), share_of(14) + 0.2);
}

TEST(Repeated, IsTheSameInSeveralThreads) {
    const LinearSpace space = line_and();
    const Truth truth = truth_of(space, plain() + wave_of(15));
    const auto one = repeat(space, truth.evidence, truth.diagnosis,
                            {.count = 20, .draws = 500, .threads = 1}),
               two = repeat(space, truth.evidence, truth.diagnosis,
                            {.count = 20, .draws = 500, .threads = 2});
    EXPECT_EQ(one->same, two->same);
}

TEST(Repeated, IsNotStatedWithoutAnAcceptedExplanation) {
    const LinearSpace space = line_and();
    Measuring measuring(3);
    const Evidence evidence = measuring.of(
        plain() + 20 * over_places([](double x) { return std::cos(40 * x) + std::sin(25 * x); }));
    const Diagnosis d = diagnose(space, evidence, quickly());
    ASSERT_TRUE(d.confidence_set.empty());
    EXPECT_FALSE(repeat(space, evidence, d));
}

TEST(LinearisedSpace, PredictsAsTheModelAboutWhichItIsTangent) {
    // An effect whose amplitude is twice its value.
    LinearSpace::Column doubled = column("wave", [](double x) { return std::sin(9 * x); });
    doubled.parameter = {
        .name = "size", .lower = -4, .upper = 12, .neutral = 0, .smallest_of_interest = 0.5};
    const LinearSpace space = line_and({doubled});
    const Truth truth =
        truth_of(space, plain() + 5 * over_places([](double x) { return std::sin(9 * x); }));
    const auto about = std::ranges::find_if(
        truth.diagnosis.tried, [](const Explanation& each) { return each.chosen == EffectSet{3}; });
    ASSERT_NE(about, truth.diagnosis.tried.end());
    const LinearisedSpace linear(space, truth.diagnosis, *about);
    const EffectParameter& p = linear.candidates()[3].parameters.front();
    EXPECT_DOUBLE_EQ(p.lower, -8);
    EXPECT_DOUBLE_EQ(p.upper, 24);
    Eigen::VectorXd parameters = about->fit.parameters;
    parameters(2) /= 0.5;
    const Prediction prediction = linear.with({3})->predict(parameters, PredictionPart::slopes);
    EXPECT_NEAR((prediction.value - about->fit.prediction.value).norm(), 0, 1e-9);
    EXPECT_NEAR((prediction.jacobian.col(2) - 0.5 * doubled.values).norm(), 0, 1e-6);
}
