// Every verdict and every decision, from tests that are written down: no model is fitted.
#include "analysis/diagnosis/verdict.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pendular {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr double wanted_power = 0.8;

/// Effects a to d, and two levels of a ladder.
const std::vector<Candidate>& candidates() {
    static const std::vector<Candidate> all = {{.name = "a"},
                                               {.name = "b"},
                                               {.name = "c"},
                                               {.name = "d"},
                                               {.name = "first", .level = 1},
                                               {.name = "second", .level = 2}};
    return all;
}

enum class Score { none, slight, clear };

Finding finding(std::size_t candidate, Score score, double power, bool identifiable = true) {
    Finding result{.candidate = candidate, .power = power, .identifiable = identifiable};
    if (score == Score::none) return result;
    result.test.basis = Eigen::Vector2d(1, 0);
    result.test.statistic = score == Score::clear ? 100 : 0.1;
    return result;
}

FittedModel model_with(EffectSet effects, double chi2, bool accepted) {
    FittedModel result{.chosen = std::move(effects), .fit = {.chi2 = chi2}, .criterion = chi2};
    result.accepted = accepted;
    result.fit.converged = true;
    return result;
}

/// Tests of a model that does not fit, of whose candidates each would have been seen.
TestResults misfit() {
    TestResults tests;
    tests.base.fit.chi2 = 500, tests.dof = 50;
    for (std::size_t k = 0; k < candidates().size(); ++k) {
        tests.scan.push_back(finding(k, Score::slight, 1));
    }
    return tests;
}

/// Tests of a model that fits, of whose candidates each would have been seen.
TestResults fitting() {
    TestResults tests = misfit();
    tests.base.fit.chi2 = 50, tests.base.accepted = true;
    return tests;
}

void fits_with(TestResults& tests, const EffectSet& effects, double chi2 = 50) {
    tests.tried.push_back(model_with(effects, chi2, true));
    tests.fitting.push_back(tests.tried.back());
    for (const std::size_t k : effects) {
        tests.scan[k] = finding(k, Score::clear, 1);
    }
}

void fits_with_error_of(TestResults& tests, const std::string& part, double chi2 = 50) {
    tests.tried.push_back(model_with({}, chi2, true));
    tests.tried.back().suspect = tests.suspect_names.size();
    tests.fitting_suspects.push_back(tests.tried.back());
    tests.suspect_names.push_back(part);
}

void lead(TestResults& tests, const EffectSet& effects, double chi2) {
    tests.tried.push_back(model_with(effects, chi2, false));
    tests.leading = Leaders{.model = tests.tried.back(), .explained = 0.95, .rival_share = 0};
    for (const std::size_t k : effects) {
        tests.scan[k] = finding(k, Score::clear, 1);
    }
}

Conclusion concluded(const TestResults& tests, const Circumstances& beside = {}) {
    return conclude(candidates(), tests, wanted_power, beside);
}

TEST(Verdict, IsNothingMissingIfEveryEffectWouldHaveBeenSeen) {
    const Conclusion c = concluded(fitting());
    EXPECT_EQ(c.verdict, Verdict::nothing_missing);
    EXPECT_TRUE(c.complete);
    EXPECT_THAT(c.effects, IsEmpty());
    EXPECT_EQ(c.confidence_set.size(), 1u);
    EXPECT_EQ(c.decisions[0], Decision::absent);
}

TEST(Verdict, IsNothingMissingBesideEffectsThatNoReadingCouldShow) {
    TestResults tests = fitting();
    tests.scan[1] = finding(1, Score::none, 0, false);
    const Conclusion c = concluded(tests);
    EXPECT_EQ(c.verdict, Verdict::nothing_missing);
    EXPECT_EQ(c.decisions[1], Decision::not_identifiable);
}

TEST(Verdict, IsInconclusiveIfAnEffectCouldHaveGoneUndetected) {
    TestResults tests = fitting();
    tests.scan[2] = finding(2, Score::slight, wanted_power - 0.01);
    tests.scan[1] = finding(1, Score::slight, wanted_power);
    const Conclusion c = concluded(tests);
    EXPECT_EQ(c.verdict, Verdict::inconclusive);
    EXPECT_THAT(c.effects, ElementsAre("c"));
    EXPECT_EQ(c.decisions[2], Decision::not_excluded);
    EXPECT_EQ(c.decisions[1], Decision::absent);
}

TEST(Verdict, IsInconclusiveIfErrorsAreAssumed) {
    TestResults tests = fitting();
    tests.errors_assumed = true;
    EXPECT_EQ(concluded(tests).verdict, Verdict::inconclusive);
}

TEST(Verdict, IsInconclusiveIfNoEffectCouldBeSeen) {
    TestResults tests = fitting();
    for (Finding& each : tests.scan) {
        each.identifiable = false;
    }
    EXPECT_EQ(concluded(tests).verdict, Verdict::inconclusive);
}

TEST(Verdict, KeepsAnEffectThatExplainsMostBesidePairsThatFit) {
    TestResults tests = misfit();
    fits_with(tests, {0, 1});
    tests.tried.push_back(model_with({2}, 90, false));  // removes 80 % of 450 ...
    tests.tried.back().fit.dof = 0;
    EXPECT_THAT(concluded(tests).effects, ElementsAre("a", "b"));
    tests.tried.back().fit.chi2 = 44;  // ... 90 %
    const Conclusion c = concluded(tests);
    EXPECT_EQ(c.verdict, Verdict::indistinguishable);
    EXPECT_THAT(c.effects, ElementsAre("a", "b", "c"));
    EXPECT_EQ(c.confidence_set.size(), 2u);
    EXPECT_EQ(c.decisions[2], Decision::may_be_missing);
}

TEST(Verdict, NamesAPairWhoseMemberExplainsMost) {
    TestResults tests = misfit();
    fits_with(tests, {0, 1});
    tests.tried.push_back(model_with({1}, 30, false));
    EXPECT_EQ(concluded(tests).verdict, Verdict::missing);
    EXPECT_THAT(concluded(tests).effects, ElementsAre("a", "b"));
    tests.tried.push_back(model_with({2}, 35, false));  // less than that member
    EXPECT_EQ(concluded(tests).verdict, Verdict::missing);
    tests.tried.pop_back();
    fits_with(tests, {0, 3});  // pairs that share the effect which explains little
    EXPECT_EQ(concluded(tests).verdict, Verdict::indistinguishable);
    EXPECT_THAT(concluded(tests).effects, ElementsAre("a", "b", "d"));
}

TEST(Verdict, LetsNoEffectThatExplainsMostBesideOneThatFits) {
    TestResults tests = misfit();
    fits_with(tests, {0});
    fits_with(tests, {1, 2});
    tests.tried.push_back(model_with({3}, 30, false));
    EXPECT_THAT(concluded(tests).effects, ElementsAre("a", "b", "c"));
}

TEST(Verdict, IsMissingIfOneEffectFits) {
    TestResults tests = misfit();
    fits_with(tests, {1});
    tests.scan[0] = finding(0, Score::clear, 1);
    const Conclusion c = concluded(tests);
    EXPECT_EQ(c.verdict, Verdict::missing);
    EXPECT_TRUE(c.complete);
    EXPECT_THAT(c.effects, ElementsAre("b"));
    EXPECT_EQ(c.decisions[1], Decision::missing);
    EXPECT_EQ(c.decisions[0], Decision::does_not_explain);
    EXPECT_EQ(c.decisions[2], Decision::no_sign);
}

TEST(Verdict, NamesWhatAllModelsThatFitShare) {
    TestResults tests = misfit();
    fits_with(tests, {0, 1});
    fits_with(tests, {1, 2});
    const Conclusion c = concluded(tests);
    EXPECT_EQ(c.verdict, Verdict::missing);
    EXPECT_THAT(c.effects, ElementsAre("b"));
    EXPECT_EQ(c.decisions[0], Decision::may_be_missing_too);
    EXPECT_EQ(c.decisions[1], Decision::missing);
}

TEST(Verdict, IsIndistinguishableIfModelsThatFitShareNothing) {
    TestResults tests = misfit();
    fits_with(tests, {2});
    fits_with(tests, {0});
    const Conclusion c = concluded(tests);
    EXPECT_EQ(c.verdict, Verdict::indistinguishable);
    EXPECT_THAT(c.effects, ElementsAre("a", "c"));
    EXPECT_EQ(c.decisions[0], Decision::may_be_missing);
}

TEST(Verdict, TakesTheLowestLevelOfALadder) {
    TestResults tests = misfit();
    fits_with(tests, {5});
    fits_with(tests, {4});
    const Conclusion c = concluded(tests);
    EXPECT_EQ(c.verdict, Verdict::missing);
    EXPECT_THAT(c.effects, ElementsAre("first"));
    EXPECT_EQ(c.decisions[5], Decision::contains_missing);
}

TEST(Verdict, TakesNoImprobableLevelOfALadderAlone) {
    TestResults tests = misfit();
    fits_with(tests, {5});
    fits_with(tests, {4});
    tests.fitting[0].lack_of_fit_p = 0.5, tests.fitting[1].lack_of_fit_p = 0.01;
    const Conclusion c = concluded(tests);
    EXPECT_EQ(c.verdict, Verdict::indistinguishable);
    EXPECT_THAT(c.effects, ElementsAre("first", "second"));
}

TEST(Verdict, IsSuspectMeasurementIfOnlyAnErrorOfMeasurementFits) {
    TestResults tests = misfit();
    fits_with_error_of(tests, "the readings of dry_1.csv");
    const Conclusion c = concluded(tests);
    EXPECT_EQ(c.verdict, Verdict::suspect_measurement);
    EXPECT_FALSE(c.overruled);
    EXPECT_THAT(c.effects, IsEmpty());
    EXPECT_THAT(c.suspects, ElementsAre("the readings of dry_1.csv"));
}

TEST(Verdict, NamesSuspectsBesideEffectsOnlyIfTheyFitAsWell) {
    TestResults tests = misfit();
    fits_with(tests, {1}, 50);
    fits_with_error_of(tests, "worse", 51);
    fits_with_error_of(tests, "as good", 50);
    const Conclusion c = concluded(tests);
    EXPECT_EQ(c.verdict, Verdict::missing);
    EXPECT_THAT(c.suspects, ElementsAre("as good"));
}

TEST(Verdict, IsUnknownIfNothingFits) {
    TestResults tests = misfit();
    tests.tried.push_back(model_with({0}, 90, false));
    tests.scan[0] = finding(0, Score::clear, 1);
    tests.scan[0].refitted_reduction = 410;  // of an excess of 450
    tests.tried.push_back(model_with({1}, 400, false));
    tests.tried.back().fit.converged = false;
    const Conclusion c = concluded(tests);
    EXPECT_EQ(c.verdict, Verdict::unknown);
    EXPECT_FALSE(c.complete);
    EXPECT_TRUE(c.proposals_stand);
    EXPECT_EQ(c.decisions[0], Decision::explains_most_not_all);
    EXPECT_EQ(c.decisions[1], Decision::not_converged);
    EXPECT_EQ(c.decisions[2], Decision::no_sign);
}

TEST(Verdict, IsMissingWithLeadersIfTheyExplainMost) {
    TestResults tests = misfit();
    lead(tests, {2}, 70);
    const Conclusion c = concluded(tests);
    EXPECT_EQ(c.verdict, Verdict::missing);
    EXPECT_FALSE(c.complete);
    ASSERT_TRUE(c.leaders);
    EXPECT_FALSE(c.proposals_stand);
    EXPECT_THAT(c.effects, ElementsAre("c"));
    EXPECT_EQ(c.decisions[2], Decision::missing_with_others);
}

TEST(Verdict, GivesLeadersUpOnlyForClearlyBetterProposals) {
    TestResults tests = misfit();
    lead(tests, {2}, 70);
    const auto with = [&](Circumstances::Proposed proposed) {
        return concluded(tests, {.proposals = {proposed}});
    };
    EXPECT_EQ(with({true, 1, 60.1}).verdict, Verdict::missing);
    EXPECT_EQ(with({false, 1, 50}).verdict, Verdict::missing) << "does not fit";
    EXPECT_EQ(with({true, 2, 50}).verdict, Verdict::missing) << "two changes against one effect";
    const Conclusion c = with({true, 1, 59.9});
    EXPECT_EQ(c.verdict, Verdict::unknown);
    EXPECT_TRUE(c.proposals_stand);
    EXPECT_FALSE(c.leaders);
    EXPECT_THAT(c.effects, IsEmpty());
    EXPECT_EQ(c.decisions[2], Decision::does_not_explain);
}

TEST(Verdict, GivesEffectsThatFitUpOnlyForClearlyBetterProposals) {
    TestResults tests = misfit();
    fits_with(tests, {1}, 62);
    fits_with(tests, {2}, 60);
    const auto with = [&](Circumstances::Proposed proposed) {
        return concluded(tests, {.proposals = {proposed}});
    };
    for (const auto& weaker :
         {Circumstances::Proposed{true, 1, 50.1}, {false, 1, 40}, {true, 2, 40}}) {
        const Conclusion c = with(weaker);
        EXPECT_EQ(c.verdict, Verdict::indistinguishable);
        EXPECT_TRUE(c.complete);
        EXPECT_FALSE(c.proposals_stand);
        EXPECT_EQ(c.confidence_set.size(), 2u);
    }
    TestResults pairs = misfit();
    fits_with(pairs, {0, 1}, 60);
    EXPECT_EQ(concluded(pairs, {.proposals = {{true, 2, 40}}}).verdict, Verdict::missing);
    const Conclusion c = with({true, 1, 49.9});
    EXPECT_EQ(c.verdict, Verdict::unknown);
    EXPECT_FALSE(c.complete);
    EXPECT_TRUE(c.proposals_stand);
    EXPECT_TRUE(c.outdone());
    EXPECT_THAT(c.effects, IsEmpty());
    EXPECT_THAT(c.confidence_set, IsEmpty());
    EXPECT_EQ(c.decisions[1], Decision::outdone);
    EXPECT_EQ(c.decisions[2], Decision::outdone);
}

TEST(Verdict, IsOverruledByADoubtfulMeasurement) {
    const Circumstances doubtful{.doubtful = {"the unit of the torque"}};
    TestResults fits = misfit(), leads = misfit();
    fits_with(fits, {1});
    lead(leads, {2}, 70);
    for (const TestResults& tests : {fitting(), misfit(), fits, leads}) {
        const Conclusion c = concluded(tests, doubtful);
        EXPECT_EQ(c.verdict, Verdict::suspect_measurement);
        EXPECT_TRUE(c.overruled);
        EXPECT_TRUE(c.complete);
        EXPECT_FALSE(c.leaders);
        EXPECT_FALSE(c.proposals_stand);
        EXPECT_THAT(c.effects, IsEmpty());
        EXPECT_THAT(c.suspects, ElementsAre("the unit of the torque"));
    }
    const Conclusion c = concluded(leads, {.doubtful = {"the unit of the torque"},
                                           .proposals = {{true, 1, 10}},
                                           .recordings_explain_most = true});
    EXPECT_EQ(c.verdict, Verdict::suspect_measurement);
    EXPECT_FALSE(c.proposals_stand);
    EXPECT_TRUE(c.recordings_first);
}

TEST(Verdict, IsTheSameAnswerOnlyAboutTheSameEffects) {
    TestResults one = misfit(), other = misfit();
    fits_with(one, {1}), fits_with(other, {2});
    EXPECT_TRUE(same_answer(concluded(one), concluded(one)));
    EXPECT_FALSE(same_answer(concluded(one), concluded(other)));
    EXPECT_FALSE(same_answer(concluded(one), concluded(one, {.doubtful = {"the torque"}})));
    TestResults beside = one, suspect = misfit(), suspects = misfit();
    fits_with_error_of(beside, "dry_1.csv");
    EXPECT_TRUE(same_answer(concluded(one), concluded(beside))) << "the effect is the same";
    fits_with_error_of(suspect, "dry_1.csv"), fits_with_error_of(suspects, "dry_2.csv");
    EXPECT_FALSE(same_answer(concluded(suspect), concluded(suspects)));
}

TEST(Verdict, ComesAfterRecordingsThatExplainMost) {
    EXPECT_FALSE(concluded(misfit()).recordings_first);
    EXPECT_TRUE(concluded(misfit(), {.recordings_explain_most = true}).recordings_first);
}

}  // namespace
}  // namespace pendular
