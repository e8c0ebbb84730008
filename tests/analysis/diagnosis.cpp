// Diagnoses of linear models, where all laws are exact. Rates are held to what binomial scatter
// allows: seeds are fixed, ranges hold 99 %.
#include "analysis/diagnosis/diagnosis.h"

#include <cmath>
#include <numbers>
#include <random>

#include "data/input_error.h"
#include "tests/support/golden.h"
#include "tests/support/line_study.h"

using namespace pendular;
using ::testing::ElementsAre;
using ::testing::UnorderedElementsAre;

TEST(Diagnosis, NamesWhatIsMissingAndWhatItsAdditionBrings) {
    const LinearSpace space = line_and();
    // Noncentrality 60: g'Pg of the wave per amplitude squared.
    const Eigen::VectorXd wave =
        over_places([](double x) { return std::sin(3 * std::numbers::pi * x); });
    const double amplitude = std::sqrt(60 / wave.squaredNorm());
    Measuring measuring(3);
    int right = 0;
    for (int study = 0; study < 40; ++study) {
        const Evidence evidence = measuring.of(plain() + amplitude * wave);
        const Diagnosis d = diagnose(space, evidence, quickly());
        if (d.verdict != Verdict::missing || !d.complete ||
            d.confidence_set.front().chosen.size() > 1)
            continue;
        ++right;
        EXPECT_THAT(d.effects, ElementsAre("wave"));
        const Finding& first = d.scan.front();
        ASSERT_TRUE(first.refitted_reduction.has_value());
        // Linear: the score test foretells the refit exactly.
        EXPECT_NEAR(first.test.predicted_reduction, *first.refitted_reduction,
                    1e-6 * *first.refitted_reduction);
        EXPECT_NEAR(first.value, d.confidence_set.front().fit.parameters(2), 1e-6);
        EXPECT_NEAR(first.value, amplitude, 4 * first.standard_error);
    }
    EXPECT_GE(right, 34);  // 95 % expected
}

TEST(Diagnosis, CannotTellApartWhatLooksAlike) {
    const LinearSpace space =
        line_and({column("bow", [](double x) { return 1 - std::cos(1.2 * x); })});
    Measuring measuring(4);
    const Diagnosis d = diagnose(
        space, measuring.of(plain() + 4 * over_places([](double x) { return x * x; })), quickly());
    EXPECT_EQ(d.verdict, Verdict::indistinguishable);
    EXPECT_THAT(d.effects, UnorderedElementsAre("parabola", "bow"));
    EXPECT_GT(d.cosines(0, 1), 0.99);
}

TEST(Diagnosis, FindsAPairWhereNoSingleEffectExplains) {
    const LinearSpace space = line_and();
    Measuring measuring(5);
    const Diagnosis d =
        diagnose(space, measuring.of(plain() + over_places([](double x) {
                                         return 8 * x * x + 3 * std::sin(3 * std::numbers::pi * x);
                                     })),
                 quickly());
    EXPECT_EQ(d.verdict, Verdict::missing);
    EXPECT_THAT(d.effects, UnorderedElementsAre("parabola", "wave"));
}

TEST(Diagnosis, KeepsTheTruthWhereATestAtFivePerCentWouldRefuseIt) {
    const LinearSpace space = line_and();
    const Eigen::VectorXd wave =
        over_places([](double x) { return std::sin(3 * std::numbers::pi * x); });
    const Eigen::VectorXd truth = plain() + std::sqrt(60 / wave.squaredNorm()) * wave;
    Measuring measuring(11);
    constexpr int studies = 400;
    int held = 0;
    for (unsigned study = 1; study <= studies; ++study) {
        const Diagnosis d = diagnose(space, measuring.of(truth), quickly(study));
        held += std::ranges::any_of(
            d.confidence_set, [](const FittedModel& each) { return each.chosen == EffectSet{1}; });
    }
    // Measured: 397, and 383 without the second limit; 374 to 388 in 99 of 100 tries of 95 %.
    EXPECT_GE(held, 389);
}

TEST(Diagnosis, KeepsAPairThatIsClearlyBetterThanOneEffectThatFits) {
    // The imitator has most of what the two waves do together.
    const auto pair = [](double x) { return std::sin(8 * x) + std::cos(5 * x); };
    const LinearSpace space =
        line_and({column("sine", [](double x) { return std::sin(8 * x); }),
                  column("cosine", [](double x) { return std::cos(5 * x); }),
                  column("imitator", [](double x) {
                      return std::sin(8 * x) + std::cos(5 * x) + 0.9 * std::sin(13 * x);
                  })});
    Measuring measuring(12);
    int wrong = 0, both = 0;
    for (unsigned study = 1; study <= 100; ++study) {
        const Diagnosis d =
            diagnose(space, measuring.of(plain() + 2.2 * over_places(pair), true), quickly(study));
        wrong += d.verdict == Verdict::missing && d.effects == std::vector<std::string>{"imitator"};
        both += std::ranges::any_of(d.confidence_set, [](const FittedModel& each) {
            return each.chosen == EffectSet{3, 4};
        });
    }
    // Measured: 3 and 93; 15 and 79 where pairs are sought only if no single effect fits.
    EXPECT_LE(wrong, 8);
    EXPECT_GE(both, 87);
}

TEST(Diagnosis, KeepsTheTruthBesideARivalThatPassesTheTest) {
    const LinearSpace space = line_and(
        {column("sine", [](double x) { return std::sin(8 * x); }),
         column("imitator", [](double x) { return std::sin(8 * x) + 0.15 * std::sin(13 * x); })});
    const Eigen::VectorXd truth =
        plain() + 3 * over_places([](double x) { return std::sin(8 * x); });
    Measuring measuring(13);
    int wrong = 0;
    for (unsigned study = 1; study <= 1000; ++study) {
        const Diagnosis d = diagnose(space, measuring.of(truth), quickly(study));
        wrong += d.verdict == Verdict::missing && d.effects == std::vector<std::string>{"imitator"};
    }
    // Measured: 7, and 13 where the test alone decides about the truth.
    EXPECT_LE(wrong, 9);
}

TEST(Diagnosis, FindsTheSameInSeveralThreads) {
    const auto space = [] {
        return line_and({column("cube", [](double x) { return x * x * x; }),
                         column("ripple", [](double x) { return std::sin(4 * x + 1); }),
                         column("edge", [](double x) { return std::exp(3 * x); }),
                         column("bow", [](double x) { return std::cos(2 * x); })});
    };
    Measuring measuring(5);
    const Evidence evidence = measuring.of(
        plain() + over_places([](double x) { return 8 * x * x + 3 * std::sin(9.4 * x); }));
    DiagnosisOptions options = quickly();
    const Diagnosis alone = diagnose(space(), evidence, options);
    options.threads = 2;
    const Diagnosis together = diagnose(space(), evidence, options);
    ASSERT_EQ(together.tried.size(), alone.tried.size());
    for (std::size_t k = 0; k < alone.tried.size(); ++k) {
        EXPECT_EQ(together.tried[k].chosen, alone.tried[k].chosen);
        EXPECT_EQ(together.tried[k].fit.chi2, alone.tried[k].fit.chi2);
        EXPECT_EQ(together.tried[k].accepted, alone.tried[k].accepted);
    }
    EXPECT_EQ(together.effects, alone.effects);
}

TEST(Diagnosis, EndsItsThreadsWhereItIsInterrupted) {
    const LinearSpace space = line_and();
    Measuring measuring(5);
    DiagnosisOptions options = quickly();
    options.threads = 2;
    options.progress = [](std::string_view what, std::size_t, std::size_t) {
        if (what == "suspects") throw std::runtime_error("enough");
    };
    const Evidence evidence = measuring.of(
        plain() + over_places([](double x) { return 8 * x * x + 3 * std::sin(9.4 * x); }));
    EXPECT_THROW(diagnose(space, evidence, options), std::runtime_error);
}

TEST(Diagnosis, SuspectsOneConditionRatherThanAnEffect) {
    const LinearSpace space = line_and();
    Measuring measuring(6);
    Eigen::VectorXd truth = plain();
    truth.segment<2>(12).array() += 7;  // condition 6
    int right = 0;
    for (unsigned study = 1; study <= 20; ++study) {
        const Diagnosis d = diagnose(space, measuring.of(truth), quickly(study));
        right += d.verdict == Verdict::suspect_measurement && d.effects.empty() &&
                 d.suspects == std::vector<std::string>{"condition 6"};
    }
    EXPECT_GE(right, 16);  // 19 expected
}

TEST(Diagnosis, SaysWhatElseWouldExplainTheReadings) {
    // The jump is one condition alone.
    const LinearSpace space =
        line_and({column("last", [](double x) { return x > 0.95 ? 1.0 : 0.0; })});
    Eigen::VectorXd truth = plain();
    truth.tail(replicates).array() += 8;
    Measuring measuring(21);
    const Diagnosis d = diagnose(space, measuring.of(truth), quickly());
    EXPECT_EQ(d.verdict, Verdict::missing);
    EXPECT_THAT(d.effects, ElementsAre("last"));
    EXPECT_THAT(d.suspects, ElementsAre("condition 14"));
}

TEST(Diagnosis, DoesNotTakeAnEffectAtItsBoundForAnExplanation) {
    LinearSpace::Column bowl = column("bowl", [](double x) { return x * x; });
    bowl.parameter.lower = 0;
    Eigen::MatrixXd base(entries, 2);
    base << Eigen::VectorXd::Ones(entries), over_places([](double x) { return x; });
    const LinearSpace space(base, {bowl, column("wave", [](double x) { return std::sin(9 * x); }),
                                   column("jump", [](double x) { return x > 0.3 ? 1.0 : 0.0; })});
    Measuring measuring(22);
    const Diagnosis d = diagnose(
        space, measuring.of(plain() - 8 * over_places([](double x) { return x * x; })), quickly());
    EXPECT_EQ(d.verdict, Verdict::unknown);
}

TEST(Diagnosis, LeavesAsideWhatIsTooLargeToBeReal) {
    // The parabola would explain it, but only with more of it than can be.
    LinearSpace::Column parabola = column("parabola", [](double x) { return x * x; });
    parabola.possible = 3;
    LinearSpace::Column never = column("never", [](double x) { return std::cos(5 * x); });
    never.possible = 0.5;  // less than the smallest effect of interest
    const LinearSpace space(Eigen::MatrixXd::Ones(entries, 1), {parabola, never});
    Measuring measuring(23);
    const Diagnosis d = diagnose(
        space, measuring.of(over_places([](double x) { return 5 + 12 * x * x; })), quickly());
    EXPECT_EQ(d.verdict, Verdict::unknown);
    EXPECT_EQ(d.scan.size(), 2u);
}

TEST(ScoreTest, TakesOutWhatErrorsOfTheModelAdd) {
    // Errors of the prediction and of the change, correlated by 0.8.
    constexpr double of_prediction = 0.5, of_change = 0.1, together = 0.8;
    const Eigen::VectorXd change = over_places([](double x) { return 0.5 * std::cos(2 * x); });
    const Eigen::MatrixXd one = Eigen::MatrixXd::Identity(entries, entries);
    std::mt19937_64 random(24);
    std::normal_distribution<double> normal;
    const auto draw = [&] {
        return Eigen::VectorXd(
            Eigen::VectorXd::NullaryExpr(entries, [&] { return normal(random); }));
    };
    double corrected = 0, uncorrected = 0;
    constexpr int studies = 2000;
    for (int study = 0; study < studies; ++study) {
        const Eigen::VectorXd shared = draw();
        const Eigen::VectorXd off = of_prediction * shared,
                              seen = change +
                                     of_change * (together * shared +
                                                  std::sqrt(1 - together * together) * draw());
        const Prediction prediction{plain() + off,
                                    Eigen::MatrixXd::Ones(entries, 1),
                                    of_prediction * of_prediction * one,
                                    {}};
        const WeightedResiduals residuals({plain() + draw(), one}, prediction);
        Signature signature{.change = seen};
        uncorrected += score_test(residuals, signature, false).estimate(0);
        signature.errors = {of_change * of_change * one,
                            together * of_prediction * of_change * one};
        const ScoreTest test = score_test(residuals, signature, false);
        ASSERT_GT(test.information, 0);
        corrected += test.estimate(0) * test.information;  // U - b
    }
    // Nothing is missing: U - b is zero on average, U is far from it.
    const double scatter = std::sqrt(entries * 0.3 / studies);
    EXPECT_NEAR(corrected / studies, 0, 3 * scatter);
    EXPECT_LT(uncorrected / studies, -0.3);
}

TEST(Diagnosis, SaysWhereItKnowsNoExplanation) {
    const LinearSpace space = line_and();
    Measuring measuring(7);
    const Diagnosis d =
        diagnose(space, measuring.of(plain() + 5 * over_places([](double x) {
                                                   return std::cos(7 * std::numbers::pi * x);
                                               })),
                 quickly());
    EXPECT_EQ(d.verdict, Verdict::unknown);
    EXPECT_TRUE(d.effects.empty());
}

TEST(Diagnosis, IsInconclusiveOfWhatCouldHide) {
    LinearSpace::Column faint = column("faint", [](double x) { return 0.05 * x * x * x * x; });
    const LinearSpace space = line_and({faint});
    Measuring measuring(8);
    Evidence evidence = measuring.of(plain());
    const Diagnosis d = diagnose(space, evidence, quickly());
    EXPECT_EQ(d.verdict, Verdict::inconclusive);
    EXPECT_THAT(d.effects, testing::Contains("faint"));
    // A size of 1 matters to all of these; the wave is seen from a few tenths on.
    for (const Finding& finding : d.scan) {
        const bool seen = finding.power >= 0.8;
        EXPECT_EQ(d.decision_on(finding), seen ? Decision::absent : Decision::not_excluded);
    }
}

TEST(Diagnosis, SaysNothingIsMissingOnlyOfMeasuredErrors) {
    // Of sizes that matter as much as these, all would be seen.
    Eigen::MatrixXd base = Eigen::MatrixXd::Ones(entries, 1);
    const auto parabola = column("parabola", [](double x) { return 10 * x * x; });
    const LinearSpace space(base, {parabola});
    Measuring measuring(9);
    int nothing_missing = 0;
    for (int study = 0; study < 20; ++study) {
        Evidence evidence = measuring.of(Eigen::VectorXd::Constant(entries, 3.0));
        nothing_missing += diagnose(space, evidence, quickly()).verdict == Verdict::nothing_missing;
        evidence.errors_assumed = true;
        EXPECT_NE(diagnose(space, evidence, quickly()).verdict, Verdict::nothing_missing);
    }
    EXPECT_GE(nothing_missing, 16);  // 19 expected
}

TEST(Diagnosis, TakesSwitchesForOnOrOff) {
    LinearSpace::Column on = column("jump", [](double x) { return x > 0.3 ? 3.0 : 0.0; });
    on.parameter = on_switch("there is a jump");
    Eigen::MatrixXd base = Eigen::MatrixXd::Ones(entries, 1);
    const LinearSpace space(base, {on, column("parabola", [](double x) { return x * x; })});
    Measuring measuring(10);
    const Diagnosis d =
        diagnose(space, measuring.of(Eigen::VectorXd::Ones(entries) + on.values), quickly());
    EXPECT_EQ(d.verdict, Verdict::missing);
    EXPECT_THAT(d.effects, ElementsAre("jump"));
    EXPECT_NEAR(d.scan.front().value, 1, 4 * d.scan.front().standard_error);
    EXPECT_EQ(d.confidence_set.front().fit.dof, entries - 1);  // nothing was fitted
}

// Higher levels contain lower ones: all that fit are one explanation, the lowest.
TEST(Diagnosis, NamesTheLowestLevelOfALadderThatExplains) {
    const auto level = [](const char* name, int place, double size) {
        LinearSpace::Column on = column(name, [](double x) { return x > 0.3 ? 1 : 0.05; });
        on.values *= size;
        on.parameter = on_switch("the level is there");
        on.level = place;
        return on;
    };
    const std::vector<LinearSpace::Column> levels = {level("fourth", 4, 3.05), level("first", 1, 1),
                                                     level("second", 2, 3),
                                                     level("third", 3, 3.02)};
    const LinearSpace space(Eigen::MatrixXd::Ones(entries, 1), levels);
    Measuring measuring(15);
    const Diagnosis d =
        diagnose(space, measuring.of(Eigen::VectorXd::Ones(entries) + levels[2].values), quickly());
    EXPECT_EQ(d.verdict, Verdict::missing);
    EXPECT_THAT(d.effects, ElementsAre("second"));
    EXPECT_EQ(d.confidence_set.size(), 1u);
    const auto decision = [&](std::size_t candidate) { return d.decisions[candidate]; };
    EXPECT_EQ(decision(3), Decision::contains_missing);
    EXPECT_EQ(decision(1), Decision::does_not_explain);
}

TEST(Diagnosis, DoesNotLookForWhatIsAbsorbed) {
    // The calibrated slope does all that this could.
    const LinearSpace space = line_and({column("slope", [](double x) { return 3 * x; })});
    Measuring measuring(11);
    const Diagnosis d = diagnose(space, measuring.of(plain()), quickly());
    const auto slope = std::ranges::find_if(
        d.scan, [&](const Finding& f) { return space.candidates()[f.candidate].name == "slope"; });
    EXPECT_FALSE(slope->identifiable);
    EXPECT_EQ(d.decision_on(*slope), Decision::not_identifiable);
    EXPECT_THAT(d.effects, testing::Not(testing::Contains("slope")));
}

TEST(Diagnosis, NeedsMoreReadingsThanParameters) {
    const LinearSpace space(Eigen::MatrixXd::Identity(3, 3), {});
    Evidence evidence;
    evidence.measured = {Eigen::VectorXd::Ones(3), Eigen::MatrixXd::Identity(3, 3)};
    evidence.errors = ErrorKnowledge::known(3);
    evidence.conditions = {{0}, {1}, {2}};
    expect_told({input_error([&] { diagnose(space, evidence, quickly()); })});
}

namespace {

/// The parabola of the candidates with a wave that no candidate has.
Eigen::VectorXd parabola_and_unknown_wave(double parabola, double wave) {
    return plain() + over_places([&](double x) {
               return parabola * x * x + wave * std::cos(7 * std::numbers::pi * x);
           });
}

}  // namespace

TEST(Diagnosis, NamesWhatExplainsMostOfAMisfitThatNothingExplainsFully) {
    const LinearSpace space = line_and();
    Measuring measuring(31);
    const Diagnosis d =
        diagnose(space, measuring.of(parabola_and_unknown_wave(60, 3.5)), quickly());
    EXPECT_EQ(d.verdict, Verdict::missing);
    EXPECT_FALSE(d.complete);
    EXPECT_THAT(d.effects, ElementsAre("parabola"));
    ASSERT_TRUE(d.leaders.has_value());
    EXPECT_GT(d.leaders->explained, 0.9);
    EXPECT_LT(d.leaders->explained, 1);
    EXPECT_LT(d.leaders->rival_share, 0.05);
    EXPECT_TRUE(d.confidence_set.empty());
}

TEST(Diagnosis, NamesNothingThatLeavesMuchOfAMisfit) {
    const LinearSpace space = line_and();
    Measuring measuring(32);
    const Diagnosis d = diagnose(space, measuring.of(parabola_and_unknown_wave(22, 6)), quickly());
    EXPECT_EQ(d.verdict, Verdict::unknown);
    EXPECT_FALSE(d.complete);
    EXPECT_TRUE(d.effects.empty());
}

TEST(Diagnosis, NamesNothingWhereARivalMightAsWellLead) {
    // The bow differs from the parabola by far less than the wave that neither explains.
    const LinearSpace space =
        line_and({column("bow", [](double x) { return 2 * (1 - std::cos(x)); })});
    Measuring measuring(33);
    const Diagnosis d =
        diagnose(space, measuring.of(parabola_and_unknown_wave(60, 4.5)), quickly());
    EXPECT_EQ(d.verdict, Verdict::unknown);
    EXPECT_TRUE(d.effects.empty());
}
