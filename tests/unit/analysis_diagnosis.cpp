// Diagnoses of linear models, where all laws are exact. Rates are held to what binomial scatter
// allows: seeds are fixed, ranges hold 99 %.
#include "analysis/diagnosis.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <random>

#include "data/input_error.h"
#include "tests/unit/linear_space.h"

using namespace pendular;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::UnorderedElementsAre;

namespace {

constexpr int conditions = 15, replicates = 2, entries = conditions * replicates;

/// Where entry k was measured, from -1 to 1; replicates follow one another.
double place(Eigen::Index k) {
    return -1 + 2.0 * static_cast<double>(k / replicates) / (conditions - 1);
}

template <typename Function>
Eigen::VectorXd over_places(Function function) {
    return Eigen::VectorXd::NullaryExpr(entries,
                                        [&](Eigen::Index k) { return function(place(k)); });
}

LinearSpace::Column column(const std::string& name, double (*shape)(double)) {
    return {.name = name, .values = over_places(shape)};
}

/// A line, which may lack a parabola, a cubic, a wave, or a jump.
LinearSpace line_and(std::vector<LinearSpace::Column> more = {}) {
    Eigen::MatrixXd base(entries, 2);
    base << Eigen::VectorXd::Ones(entries), over_places([](double x) { return x; });
    std::vector<LinearSpace::Column> columns = {
        column("parabola", [](double x) { return x * x; }),
        column("wave", [](double x) { return std::sin(3 * std::numbers::pi * x); }),
        column("jump", [](double x) { return x > 0.3 ? 1.0 : 0.0; })};
    columns.insert(columns.end(), more.begin(), more.end());
    return {base, columns};
}

class Measuring {
  public:
    explicit Measuring(std::uint64_t seed) : random_(seed) {}

    /// Readings with errors of 1 about the truth; `estimated`: believed to have the errors that
    /// replicates show.
    Evidence of(const Eigen::VectorXd& truth, bool estimated = false) {
        Evidence evidence;
        evidence.measured.value = truth;
        for (double& value : evidence.measured.value)
            value += normal_(random_);
        evidence.errors = ErrorKnowledge::known(entries);
        double variance = 1;
        if (estimated) {
            variance = 0;
            for (Eigen::Index k = 0; k < entries; k += 2) {
                variance +=
                    std::pow(evidence.measured.value(k) - evidence.measured.value(k + 1), 2) / 2;
            }
            variance /= conditions;
            evidence.errors.freedom = {conditions};
        }
        evidence.measured.covariance = variance * Eigen::MatrixXd::Identity(entries, entries);
        for (Eigen::Index k = 0; k < entries; k += 2) {
            evidence.conditions.push_back({k, k + 1});
            Suspect suspect{"condition " + std::to_string(k / 2),
                            Eigen::MatrixXd::Zero(entries, 1)};
            suspect.columns(k, 0) = suspect.columns(k + 1, 0) = 1;
            evidence.suspects.push_back(suspect);
        }
        return evidence;
    }

  private:
    std::mt19937_64 random_;
    std::normal_distribution<double> normal_;
};

DiagnosisOptions quickly() {
    return {.draws = 1000};
}

Eigen::VectorXd plain() {
    return over_places([](double x) { return 5 + 2 * x; });
}

}  // namespace

TEST(Diagnosis, CallsACompleteModelIncompleteAsOftenAsItSays) {
    const LinearSpace space = line_and();
    for (const bool estimated : {false, true}) {
        Measuring measuring(estimated ? 2 : 1);
        int alarms = 0;
        for (int study = 0; study < 300; ++study) {
            const Diagnosis d = diagnose(space, measuring.of(plain(), estimated), quickly());
            alarms += d.verdict != Verdict::nothing_missing && d.verdict != Verdict::inconclusive;
        }
        EXPECT_GE(alarms, 6) << estimated;
        EXPECT_LE(alarms, 25) << estimated;
    }
}

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
        if (d.verdict != Verdict::missing) continue;
        ++right;
        EXPECT_THAT(d.effects, ElementsAre("wave"));
        const Finding& first = d.scan.front();
        ASSERT_TRUE(first.refit_drop.has_value());
        // Linear: the score test foretells the refit exactly.
        EXPECT_NEAR(first.test.predicted_drop, *first.refit_drop, 1e-6 * *first.refit_drop);
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

TEST(Diagnosis, SuspectsOneConditionRatherThanAnEffect) {
    const LinearSpace space = line_and();
    Measuring measuring(6);
    Eigen::VectorXd truth = plain();
    truth.segment<2>(12).array() += 7;  // condition 6
    const Diagnosis d = diagnose(space, measuring.of(truth), quickly());
    EXPECT_EQ(d.verdict, Verdict::suspect_measurement);
    EXPECT_THAT(d.suspects, ElementsAre("condition 6"));
    EXPECT_TRUE(d.effects.empty());
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
        EXPECT_EQ(finding.decision, seen ? "absent" : "cannot be excluded");
    }
}

TEST(Diagnosis, SaysNothingIsMissingOnlyOfMeasuredErrors) {
    // Of sizes that matter as much as these, all would be seen.
    Eigen::MatrixXd base = Eigen::MatrixXd::Ones(entries, 1);
    const auto parabola = column("parabola", [](double x) { return 10 * x * x; });
    const LinearSpace space(base, {parabola});
    Measuring measuring(9);
    Evidence evidence = measuring.of(Eigen::VectorXd::Constant(entries, 3.0));
    EXPECT_EQ(diagnose(space, evidence, quickly()).verdict, Verdict::nothing_missing);
    evidence.errors_assumed = true;
    EXPECT_EQ(diagnose(space, evidence, quickly()).verdict, Verdict::inconclusive);
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

TEST(Diagnosis, DoesNotLookForWhatIsAbsorbed) {
    // The calibrated slope does all that this could.
    const LinearSpace space = line_and({column("slope", [](double x) { return 3 * x; })});
    Measuring measuring(11);
    const Diagnosis d = diagnose(space, measuring.of(plain()), quickly());
    const auto slope = std::ranges::find_if(
        d.scan, [&](const Finding& f) { return space.candidates()[f.candidate].name == "slope"; });
    EXPECT_FALSE(slope->identifiable);
    EXPECT_EQ(slope->decision, "cannot be seen");
    EXPECT_THAT(d.effects, testing::Not(testing::Contains("slope")));
}

TEST(Diagnosis, NeedsMoreReadingsThanParameters) {
    const LinearSpace space(Eigen::MatrixXd::Identity(3, 3), {});
    Evidence evidence;
    evidence.measured = {Eigen::VectorXd::Ones(3), Eigen::MatrixXd::Identity(3, 3)};
    evidence.errors = ErrorKnowledge::known(3);
    evidence.conditions = {{0}, {1}, {2}};
    try {
        diagnose(space, evidence, quickly());
        FAIL();
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("3 measured values and 3 calibrated parameters"));
    }
}
