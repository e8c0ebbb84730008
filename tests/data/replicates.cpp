#include "data/recordings/measurements.h"
#include "data/recordings/reading_groups.h"

#include <cmath>
#include <numbers>
#include <tuple>

#include "tests/support/golden.h"
#include "tests/support/replicated_readings.h"

namespace pendular::data_replicates_test {

using namespace replicated;

using testing::Contains;
using testing::IsEmpty;
using testing::Not;

/// By which the variance known from one pair is widened.
const double one_pair =
    std::pow(std::tan(std::numbers::pi * (0.5 * std::erfc(-std::sqrt(2.0)) - 0.5)) / 2, 2);

TEST(Replicates, AreTheSameConditionWithinTwoPercent) {
    Measurements all;
    all.readings = {reading(1000, 0.3, 0.6, 0.01), reading(1015, 0.3, 0.6, 0.01),
                    reading(1030, 0.3, 0.6, 0.01), reading(1000, 0.3, 0.6, 0.01),
                    reading(1000, 0.3, 0.6, 0.01)};
    all.readings[3].condition.liquid_content = 0.03;
    all.readings[4].condition.inertial_number = 0.0103;
    pool_replicates(all);
    std::vector<int> counts;
    for (const Reading& each : all.readings)
        counts.push_back(each.replicates);
    EXPECT_THAT(counts, testing::ElementsAre(2, 2, 1, 1, 1));
}

TEST(Replicates, FailedAfterTheSamePreshear) {
    Reading a = reading(1000, 0.5, 0.6, 0.01), b = a;
    a.condition.at_failure = b.condition.at_failure = true;
    a.condition.preshear_stress = 3000;
    b.condition.preshear_stress = 3030;
    EXPECT_TRUE(are_replicates(a, b));
    b.condition.preshear_stress = 6000;
    EXPECT_FALSE(are_replicates(a, b));
    b.condition.preshear_stress.reset();
    EXPECT_FALSE(are_replicates(a, b));
}

TEST(Replicates, AreOfTheSameFilling) {
    Reading a = reading(1000, 0.3, 0.6, 0.01), b = a;
    a.condition.bead_volume = 60e-6;
    EXPECT_FALSE(are_replicates(a, b));  // of one it is not known
    b.condition.bead_volume = 60.5e-6;
    EXPECT_TRUE(are_replicates(a, b));
    b.condition.bead_volume = 30e-6;  // where the beads' weight counts for less
    EXPECT_FALSE(are_replicates(a, b));
}

TEST(Replicates, AddTheScatterTheirOwnErrorsDoNotExplain) {
    // Two replicates at +-2 % of the ratio: s_rep^2 = ln(1.02/0.98)^2/2, about 2 x 2 %^2; errors of
    // 1 % explain 1 %^2.
    // Equal set points; a third condition without replicates gets the same excess. One pair:
    // Student's t with one degree of freedom has 95.45 % within 13.97 (its quantile is
    // tan(pi (p - 1/2))), in place of 2.
    Measurements all;
    all.readings = {reading(1000, 0.3 * 0.98, 0.6, 0.01), reading(1000, 0.3 * 1.02, 0.6, 0.01),
                    reading(3000, 0.3, 0.6, 0.01)};
    pool_replicates(all);
    for (const Reading& each : all.readings) {
        const double between = std::pow(std::log(1.02 / 0.98), 2) / 2;
        EXPECT_NEAR(relative_variance(each, 0), 1e-4 + (between - 1e-4) * one_pair, 1e-12);
        EXPECT_NEAR(relative_variance(each, 1), 1e-4, 1e-12);  // no scatter: nothing added
        EXPECT_FALSE(each.error_assumed);
    }
    expect_told(texts(all.notes()));
}

TEST(Replicates, CoverAsOftenAsTheyClaimWhenFew) {
    // 4000 experiments of six pairs and one lone reading of known truth: two of its standard errors
    // must cover it in 95.45 %, to three binomial standard deviations. Unwidened it would be 90.8
    // %.
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal;
    constexpr int experiments = 4000, pairs = 6;
    constexpr double truth = 0.3, scatter = 0.01;
    int covered = 0;
    for (int k = 0; k < experiments; ++k) {
        Measurements all;
        for (int i = 0; i < 2 * pairs; ++i)
            all.readings.push_back(
                reading(1000 * (1 + i / 2), truth * (1 + scatter * normal(random)), 0.6, 1e-6));
        all.readings.push_back(reading(1e5, truth * (1 + scatter * normal(random)), 0.6, 1e-6));
        pool_replicates(all);
        const Reading& lone = all.readings.back();
        covered += std::abs(lone.stress_ratio() - truth) <=
                   2 * std::sqrt(lone.covariance(0, 0)) / lone.condition.normal_stress;
    }
    const double expected = 0.9545, error = std::sqrt(expected * (1 - expected) / experiments);
    EXPECT_NEAR(static_cast<double>(covered) / experiments, expected, 3 * error);
}

TEST(Replicates, DoNotTakeDifferentSetPointsForScatter) {
    Measurements all;
    all.readings = {reading(1000, 0.3, 0.6, 0.001), reading(1019, 0.3, 0.6, 0.001)};
    pool_replicates(all);
    EXPECT_NEAR(relative_variance(all.readings[0], 0), 1e-6, 1e-12);
}

TEST(Replicates, RecoverAPlantedScatterAndItsCorrelation) {
    // 200 pairs: 1.5 % between replicates, correlated 0.8 between the observables, 0.5 % within.
    // With 200 degrees of freedom a variance is known to sqrt(2/200) = 10 %: limits of 3 of these.
    std::mt19937_64 random(13);
    std::normal_distribution<double> normal;
    Measurements all;
    for (int i = 0; i < 200; ++i) {
        for (int j = 0; j < 2; ++j) {
            const double a = normal(random), b = 0.8 * a + 0.6 * normal(random);
            all.readings.push_back(reading(1000 * (1 + i),
                                           0.3 * (1 + 0.015 * a + 0.005 * normal(random)),
                                           0.6 * (1 + 0.015 * b + 0.005 * normal(random)), 0.005));
        }
    }
    pool_replicates(all);
    const Reading& first = all.readings.front();
    const double expected = 0.015 * 0.015 + 0.005 * 0.005;
    EXPECT_NEAR(relative_variance(first, 0), expected, 0.3 * expected);
    EXPECT_NEAR(relative_variance(first, 1), expected, 0.3 * expected);
    const double shared = first.covariance(0, 1) / (first.value(0) * first.value(1));
    EXPECT_NEAR(shared, 0.8 * 0.015 * 0.015, 0.3 * 0.8 * 0.015 * 0.015);
}

TEST(Replicates, KnowNoCorrelationFromOnePair) {
    Measurements all;
    all.readings = {reading(1000, 0.29, 0.59, 0.001), reading(1000, 0.31, 0.61, 0.001)};
    pool_replicates(all);
    EXPECT_EQ(all.readings[0].covariance(0, 1), 0);
}

TEST(Replicates, AddNothingASecondTime) {
    Measurements all;
    all.readings = {reading(1000, 0.29, 0.59, 0.01), reading(1000, 0.31, 0.6, 0.01),
                    reading(1000, 0.30, 0.61, 0.01)};
    pool_replicates(all);
    const Eigen::Matrix2d once = all.readings[0].covariance;
    pool_replicates(all);
    for (int i = 0; i < 2; ++i)
        EXPECT_NEAR(all.readings[0].covariance(i, i), once(i, i), 1e-9 * once(i, i));
}

TEST(Replicates, StandInForErrorsThatWereNotGiven) {
    Measurements all;
    all.readings = {reading(1000, 0.29, 0.59, 0), reading(1000, 0.31, 0.61, 0),
                    reading(2000, 0.30, 0.6, 0)};
    pool_replicates(all);
    EXPECT_NEAR(relative_variance(all.readings[2], 0),
                std::pow(std::log(0.31 / 0.29), 2) / 2 * one_pair, 1e-12);
}

TEST(Replicates, LeaveTwoPercentToBeAssumedWhereNothingIsKnown) {
    Measurements all;
    all.readings = {reading(1000, 0.3, 0.6, 0), reading(2000, 0.3, 0.6, 0.01),
                    reading(3000, 0.3, 0.6, 0.01)};
    all.readings[2].covariance(1, 1) = 0;
    pool_replicates(all);
    EXPECT_NEAR(relative_variance(all.readings[0], 0), 4e-4, 1e-12);
    EXPECT_NEAR(relative_variance(all.readings[0], 1), 4e-4, 1e-12);
    EXPECT_TRUE(all.readings[0].error_assumed);
    EXPECT_NEAR(relative_variance(all.readings[1], 0), 1e-4, 1e-12);
    EXPECT_FALSE(all.readings[1].error_assumed);
    EXPECT_NEAR(relative_variance(all.readings[2], 1), 4e-4, 1e-12);
    EXPECT_TRUE(all.readings[2].error_assumed);
    ASSERT_EQ(all.notes().size(), 1u);
    expect_told({text_of(all.notes()[0])});
}

TEST(Replicates, LeaveTwoPercentToBeAssumedWhateverTheDigits) {
    // Written as 301.3 and 0.6013, without errors and replicates: the last digit is no error.
    Measurements all;
    all.readings = {reading(1000, 0.3013, 0.6013, 0), reading(2000, 0.3, 0.602, 0)};
    all.readings[1].covariance(0, 0) = std::pow(0.01 * all.readings[1].value(0), 2);
    for (Reading& each : all.readings)
        each.resolution = {0.1, 1e-4};
    pool_replicates(all);
    EXPECT_NEAR(relative_variance(all.readings[0], 0), 4e-4, 1e-8);
    EXPECT_NEAR(relative_variance(all.readings[0], 1), 4e-4, 1e-8);
    EXPECT_NEAR(relative_variance(all.readings[1], 0), 1e-4, 1e-12) << "as stated";
    EXPECT_NEAR(relative_variance(all.readings[1], 1), 4e-4, 1e-8);

    // Where one column is missing, the note names it; what follows from the error of the normal
    // stress is no statement.
    Measurements one;
    one.readings = {reading(1000, 0.3, 0.6, 0.01), reading(2000, 0.3, 0.6, 0.01)};
    for (Reading& each : one.readings)
        each.unstated[1] = true;
    pool_replicates(one);
    EXPECT_NEAR(relative_variance(one.readings[0], 0), 1e-4, 1e-12);
    EXPECT_NEAR(relative_variance(one.readings[0], 1), 1e-4 + 4e-4, 1e-12);
    expect_told(texts(one.notes()));
}

TEST(Replicates, StandInForMissingErrorsBesideStatedOnes) {
    // Three pairs state 1 % and scatter so. A reading elsewhere without an error has that scatter,
    // not none, although the pairs' errors leave no excess.
    Measurements all;
    for (int i = 0; i < 6; ++i) {
        const double ratio = 0.3 * std::exp((i % 2 ? 0.01 : -0.01) / std::numbers::sqrt2);
        all.readings.push_back(reading(1000 * (1 + i / 2), ratio, 2 * ratio, 0.01));
    }
    all.readings.push_back(reading(9000, 0.3, 0.6, 0));
    all.readings.back().origin.file = "other.csv";
    pool_replicates(all);
    EXPECT_GE(relative_variance(all.readings.back(), 0), 0.99e-4);
    EXPECT_FALSE(all.readings.back().error_assumed);
}

/// Two fillings dry and two wet, at as many normal stresses from 0.3 to 5 kPa, steps scattered by
/// 0.5 % and 0.1 %.
Measurements four_files(std::mt19937_64& random, const Eigen::Array2d& filling,
                        double load_exponent = 0, int steps = 8) {
    std::normal_distribution<double> normal;
    Measurements all;
    for (int file = 0; file < 4; ++file) {
        const Eigen::Array2d shift = filling * Eigen::Array2d(normal(random), normal(random));
        for (int step = 0; step < steps; ++step) {
            const double load = 300 * std::pow(1.5, 8.0 * step / steps);
            const double grown = std::pow(load / 1000, -load_exponent);
            const Eigen::Array2d z(normal(random), normal(random));
            const Eigen::Array2d factor = 1 + shift + grown * Eigen::Array2d(0.005, 0.001) * z;
            Reading one = reading(load, 0.3 * factor(0), 0.6 * factor(1), 1e-4);
            one.condition.liquid_content = file < 2 ? 0 : 0.03;
            one.origin = {"file_" + std::to_string(file) + ".csv", step + 2};
            one.within_run_only = true;
            all.readings.push_back(one);
        }
    }
    return all;
}

TEST(Replicates, ShareTheErrorOfTheirFilling) {
    // Fillings of 1 % and 0.5 %. Two differences tell little: over 200 laboratories the mean of the
    // variances, drawn towards the usual size, is the true one within a factor of two. The usual
    // size counts like a third difference; for three they are widened by (3.3068/2)^2, from
    // Student's quantile.
    const double widening = std::pow(3.3068 / 2, 2);
    std::mt19937_64 random(3);
    Eigen::Array2d mean = Eigen::Array2d::Zero();
    constexpr int laboratories = 200;
    for (int k = 0; k < laboratories; ++k) {
        Measurements all = four_files(random, {0.01, 0.005});
        pool_replicates(all);
        for (const int o : {0, 1})
            mean(o) += all.scatter.filling[static_cast<std::size_t>(o)].variance / laboratories;
        for (const Reading& one : all.readings) {
            for (const SharedError& error : one.shared)
                EXPECT_LE(error.size.squaredNorm(), one.covariance.trace());
        }
    }
    mean /= widening;
    EXPECT_GT(mean(0), 0.5 * 1e-4);
    EXPECT_LT(mean(0), 2 * 1e-4);
    EXPECT_GT(mean(1), 0.5 * 0.25e-4);
    EXPECT_LT(mean(1), 2 * 0.25e-4);
}

TEST(Replicates, SeldomShareAnErrorWhereFillingsHaveNone) {
    // Files differ in 3 % of laboratories by chance; of 200, 12 or more have a probability of 2 %.
    // What two differences do not exclude is on average smaller than the scatter of a step, 0.5 %.
    std::mt19937_64 random(7);
    int seen = 0;
    double mean = 0;
    constexpr int laboratories = 200;
    for (int k = 0; k < laboratories; ++k) {
        Measurements all = four_files(random, {0, 0});
        pool_replicates(all);
        seen += std::isfinite(all.scatter.filling[0].freedom_between);
        mean += all.scatter.filling[0].variance / laboratories;
    }
    EXPECT_LE(seen, 12);
    EXPECT_LT(mean, std::pow(0.005, 2));
}

TEST(Replicates, AreNotWidenedByOneFileInOtherUnits) {
    std::mt19937_64 random(4);
    const Measurements right = four_files(random, {0, 0});
    Measurements pooled = right, wrong = right;
    pool_replicates(pooled);
    for (Reading& one : wrong.readings) {
        if (one.origin.file != "file_3.csv") continue;
        one.value(0) *= 10;
        one.covariance.row(0) *= 10;
        one.covariance.col(0) *= 10;
    }
    pool_replicates(wrong);
    ASSERT_EQ(wrong.doubts().size(), 1u);
    expect_told({text_of(wrong.doubts()[0])});
    // The dry files keep their errors but for the wider filling error of one pair in place of two.
    EXPECT_LT(relative_variance(wrong.readings[0], 0),
              10 * relative_variance(pooled.readings[0], 0));
    EXPECT_GT(relative_variance(wrong.readings[31], 0), 1);
}

/// A dry and a wet file in each other's place are named; files that differ otherwise are not.
TEST(Replicates, MayHaveEachOthersLiquidContents) {
    const auto doubts = [](double dry_a, double wet_a) {
        Measurements all;
        for (const auto& [file, content, ratio] :
             {std::tuple("dry_A.csv", 0.0, dry_a), std::tuple("dry_B.csv", 0.0, 0.36),
              std::tuple("wet_A.csv", 0.03, wet_a), std::tuple("wet_B.csv", 0.03, 0.43)})
            for (int k = 0; k < 4; ++k) {
                // Steps within a file scatter by 0.5 %.
                const double scatter = 1 + 0.005 * ((k * 7 + file[4]) % 3 - 1);
                Reading& one =
                    all.readings.emplace_back(reading(500 * (1 << k), ratio * scatter, 0.6, 0.01));
                one.condition.liquid_content = content;
                one.condition.inertial_number = content > 0 ? 0.0098 : 0.01;
                one.within_run_only = true;
                one.origin.file = file;
                one.step = k + 1;
            }
        pool_replicates(all);
        std::string text;
        for (const Remark& doubt : all.doubts())
            text += text_of(doubt) + "\n";
        return text;
    };
    EXPECT_THAT(doubts(0.36, 0.43), IsEmpty());
    expect_told({doubts(0.43, 0.36), doubts(0.43, 0.43)});
}

TEST(Replicates, AreNotedWhereFillingsDifferMuch) {
    std::mt19937_64 random(8);
    Measurements all = four_files(random, {0, 0});
    for (Reading& one : all.readings) {
        if (one.origin.file == "file_3.csv") one.value(0) *= 1.05;
    }
    pool_replicates(all);
    EXPECT_TRUE(all.doubts().empty());
    Measurements alike = four_files(random, {0.005, 0});
    pool_replicates(alike);
    expect_told(texts(all.notes()));
    EXPECT_THAT(alike.notes(), testing::IsEmpty());
}

TEST(Replicates, ScatterMoreAtLowLoad) {
    // Two pairs of twenty conditions tell the exponent to about 0.15, and the prior of 0 +- 0.5
    // pulls it by a tenth: the mean over 50 laboratories lies between 0.5 and 0.8.
    std::mt19937_64 random(5);
    double mean = 0;
    for (int k = 0; k < 50; ++k) {
        Measurements all = four_files(random, {0, 0}, 0.7, 20);
        pool_replicates(all);
        mean += all.scatter.load_exponent(0) / 50;
    }
    EXPECT_GT(mean, 0.5);
    EXPECT_LT(mean, 0.8);
}

TEST(Replicates, NameAReadingFarFromItsReplicate) {
    std::mt19937_64 random(6);
    Measurements all = four_files(random, {0, 0});
    all.readings[5].value(0) *= 1.08;  // sixteen times the scatter of a step
    pool_replicates(all);
    ASSERT_EQ(all.doubts().size(), 1u);
    Measurements recorded = four_files(random, {0, 0});
    recorded.readings[5].value(0) *= 1.08;
    recorded.readings[5].step = 6;
    pool_replicates(recorded);
    ASSERT_EQ(recorded.doubts().size(), 1u);
    EXPECT_GT(relative_variance(all.readings[5], 0), std::pow(0.03, 2));
    EXPECT_LT(relative_variance(all.readings[4], 0), std::pow(0.03, 2));
    expect_told({text_of(all.doubts()[0]), text_of(recorded.doubts()[0])});
}

TEST(Replicates, ShareTheErrorOfRounding) {
    // Written as 0.60 twice: they agree exactly, and both may be off by 0.005.
    Measurements all;
    for (const double stress : {1000.0, 1000.0, 2000.0, 2000.0}) {
        Reading one = reading(stress, 0.3, 0.6, 0);
        one.covariance(0, 0) = 1;
        one.resolution = {0, 0.01};
        all.readings.push_back(one);
    }
    pool_replicates(all);
    EXPECT_NEAR(all.readings[0].covariance(1, 1), 1e-4 / 12, 1e-9);
    ASSERT_EQ(all.readings[0].shared.size(), 1u);
    EXPECT_EQ(all.readings[0].shared[0].source, all.readings[1].shared[0].source);
    EXPECT_NE(all.readings[0].shared[0].source, all.readings[2].shared[0].source);
}

TEST(Replicates, LeaveRoundingOutOfTheScatterOfSteps) {
    // Every other stress is written in steps of 3 to 5 %, over a scatter of 0.5 %: with all
    // deviations taken alike, the mean square would be about (0.9 %)^2.
    std::mt19937_64 random(9);
    double mean = 0;
    constexpr int laboratories = 50;
    for (int k = 0; k < laboratories; ++k) {
        Measurements all = four_files(random, {0, 0});
        for (std::size_t r = 0; r < all.readings.size(); r += 2) {
            Reading& one = all.readings[r];
            const double relative = 0.03 + 0.0013 * static_cast<double>(r % 8) + 0.0002 * k;
            const double step = relative * 0.3 * one.condition.normal_stress;
            one.value(0) = std::round(one.value(0) / step) * step;
            one.resolution(0) = step;
        }
        pool_replicates(all);
        mean += all.scatter.groups[0].excess(0, 0) / laboratories;
        EXPECT_GT(all.readings[0].covariance(0, 0),
                  std::pow(all.readings[0].resolution(0), 2) / 12);
    }
    EXPECT_GT(mean, std::pow(0.004, 2));
    EXPECT_LT(mean, std::pow(0.006, 2));
}

TEST(Replicates, TellHowWellTheirMeanSquareIsKnown) {
    // A pair of recordings that differ by 0.4 %: mean square (0.4 %)^2/2 = 8e-6, which the mean of
    // their variances within runs explains, (2 (0.4 %)^2 + 0)/2. The second, with hardly an error
    // of its own, has the mean square all the same, widened for one degree of freedom: the law of a
    // test is that of one degree of freedom too. Its own variance of 1e-10 is not widened.
    Measurements all;
    all.readings = {reading(1000, 0.3, 0.6, 0.004 * std::numbers::sqrt2),
                    reading(1000, 0.3 * std::exp(0.004), 0.6, 1e-5)};
    for (Reading& one : all.readings)
        one.within_run_only = true;
    Measurements stated_errors = all;
    pool_replicates(all);
    ASSERT_EQ(all.scatter.groups.at(0).excess(0, 0), 0);
    const Reading& quiet = all.readings[1];
    EXPECT_NEAR(relative_variance(quiet, 0), 8e-6 * one_pair, 49e-10);
    EXPECT_NEAR(quiet.estimated_covariance()(0, 0) / std::pow(quiet.value(0), 2), 8e-6, 1e-11);
    for (const Reading& each : all.readings) {
        EXPECT_EQ(each.scatter_freedom(0), 1);
    }
    expect_told(texts(all.notes()));

    // Errors that were stated and explain the scatter are known, and nothing is widened.
    for (Reading& one : stated_errors.readings)
        one.within_run_only = false;
    stated_errors.readings[1].value(1) *= std::exp(0.004);  // else they agree better than stated
    pool_replicates(stated_errors);
    for (const Reading& each : stated_errors.readings) {
        EXPECT_TRUE(std::isinf(each.scatter_freedom(0)));
        EXPECT_EQ(each.widened_by(0, 0), 0);
    }
    EXPECT_THAT(stated_errors.notes(), testing::IsEmpty());
}

TEST(Replicates, AreWantedOfRecordings) {
    // Errors within a recording are not the error of a measurement.
    Measurements all;
    all.readings = {reading(1000, 0.3, 0.6, 0.001), reading(2000, 0.3, 0.6, 0.001)};
    for (Reading& one : all.readings)
        one.within_run_only = true;
    Measurements stated = all;
    pool_replicates(all);
    EXPECT_TRUE(all.readings[0].error_assumed);
    EXPECT_NEAR(relative_variance(all.readings[0], 0), 4e-4 + 1e-6, 1e-12);
    pool_replicates(stated, StatedScatter{.step = {0.01, 0.003}, .filling = {0.005, 0}});
    EXPECT_FALSE(stated.readings[0].error_assumed);
    EXPECT_NEAR(relative_variance(stated.readings[0], 0), 1e-4 + 0.25e-4 + 1e-6, 1e-12);
    EXPECT_NEAR(relative_variance(stated.readings[0], 1), 9e-6 + 1e-6, 1e-12);
}

}  // namespace pendular::data_replicates_test
