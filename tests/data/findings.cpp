// What the rows of recordings show besides the steady means: found where it was put into simulated
// recordings, and not in ordinary ones.
#include "data/remarks/wording.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "data/recordings/findings/detectors.h"
#include "data/recordings/findings/drift.h"
#include "data/recordings/measurements.h"
#include "tests/support/golden.h"
#include "tests/support/ordinary_studies.h"

namespace pendular::data_findings_test {

using Kind = Remark::Kind;
using testing::Contains;
using testing::Each;
using testing::Field;
using testing::IsEmpty;

std::vector<Remark> of_kind(const Measurements& m, Kind kind, const std::string& quantity = "") {
    std::vector<Remark> result;
    std::ranges::copy_if(m.faults(true), std::back_inserter(result), [&](const Remark& f) {
        return f.kind == kind && (quantity.empty() || f.quantity == quantity);
    });
    return result;
}

// 100 studies with 5 % of false alarms would give more than 11 with a probability of 0.4 %.
TEST(TwoSidedP, IsOneWhereNothingIsKnown) {
    EXPECT_EQ(two_sided_p(std::nan(""), 5), 1);
    EXPECT_EQ(two_sided_p(std::numeric_limits<double>::infinity(), 5), 0);
    EXPECT_NEAR(two_sided_p(-2.571, 5), 0.05, 1e-4);  // table of Student's t
}

TEST(RecordingFindings, AreRareInOrdinaryStudies) {
    int count = alarms(30, 3, {}, 1);
    count += alarms(30, 4, {.torque = 0.02, .correlation_rows = 10}, 100);
    count += alarms(20, 6, {.correlation_rows = 0.2, .torque_resolution = 2e-4}, 200);
    count += alarms(20, 8, {.filling = 0.04, .step = 0.02}, 300);
    RecordProperty("alarms", count);
    EXPECT_LE(count, 11);
}

TEST(RecordingFindings, AreNoneInTheExamples) {
    const std::filesystem::path root = PENDULAR_SOURCE_DIR;
    for (const char* const study :
         {"examples/dry-recordings", "examples/hidden-effect", "examples/rumpf-to-full",
          "examples/water-glass", "examples/wet", "tests/hidden_effects/study_1",
          "tests/hidden_effects/study_2", "tests/hidden_effects/study_3",
          "tests/hidden_effects/study_4", "tests/hidden_effects/study_5"})
        EXPECT_THAT(sentences(read_measurements(read_study(root / study)).faults(true)), IsEmpty())
            << study;
}

TEST(Wobble, IsFoundInEachOfTwentyStudies) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const Measurements m = study_of(3, seed, {}, [](RowOfStep row, int, int) {
            row.torque *= 1 + 0.02 * std::cos(row.angle + 0.7);
        });
        const auto found = of_kind(m, Kind::wobble, "torque");
        ASSERT_FALSE(found.empty()) << seed;
        for (const Remark& each : found) {
            EXPECT_EQ(each.period, 1);
            EXPECT_NEAR(each.relative, 0.02, 4 * each.relative_error);
        }
    }
}

TEST(Wobble, OfTheGapIsToldWithItsUnit) {
    const Measurements m = study_of(
        3, 1, {}, [](RowOfStep row, int, int) { row.gap += 3e-5 * std::sin(2 * row.angle); });
    expect_told(sentences(m.faults(true)));
    EXPECT_EQ(sentences(m.faults(true), true).size(), 9u);
}

/// Two and a half turns of a lid at constant speed, with a wobble of 10 % of the torque.
StepSeries wobbling() {
    StepSeries series;
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal;
    for (int k = 0; k < 250; ++k) {
        series.time.push_back(k);
        series.torque.push_back(1 + 0.1 * std::sin(2 * M_PI * k / 100.0) + 0.01 * normal(random));
        series.normal_force.push_back(1 + 0.01 * normal(random));
        series.height.push_back(1 + 0.001 * normal(random));
        series.angular_velocity.push_back(2 * M_PI / 100);
        series.line.push_back(k);
    }
    return series;
}

TEST(Wobble, LeavesMeansOverWholeTurns) {
    const StepSeries series = wobbling();
    const std::size_t begin = whole_turns_begin(series, periodic_columns(series));
    EXPECT_EQ(begin, 50u);
    EXPECT_GT(mean_of_correlated(series.torque).value, 1.01);
    EXPECT_NEAR(mean_of_correlated(series.from(begin).torque).value, 1, 0.003);
}

TEST(Wobble, NeedsOneAndAHalfTurns) {
    StepSeries series = wobbling();
    EXPECT_EQ(harmonics(series.torque, rotation_angle(series)).size(), 2u);
    for (double& speed : series.angular_velocity)
        speed *= 0.55;  // 1.4 turns
    EXPECT_THAT(harmonics(series.torque, rotation_angle(series)), IsEmpty());
}

TEST(LevelChange, FromTheNinthOfFourteenRecordingsIsFoundInEachOfTwentyStudies) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const Measurements m = study_of(
            14, seed, {}, [](RowOfStep row, int, int file) { row.torque *= file >= 8 ? 1.1 : 1; });
        const auto found = of_kind(m, Kind::level_change);
        ASSERT_EQ(found.size(), 1u) << seed;
        EXPECT_EQ(found[0].quantity, "torque");
        EXPECT_THAT(found[0].files.front(), testing::EndsWith("run_09.csv"));
        EXPECT_EQ(found[0].files.size(), 6u);
        EXPECT_NEAR(found[0].relative, 0.1, 4 * found[0].relative_error);
        EXPECT_FALSE(found[0].offset);
    }
}

TEST(LevelChange, IsAnOffsetWhereAllTorquesChangeAlike) {
    const Measurements m = study_of(
        10, 3, {}, [](RowOfStep row, int, int file) { row.torque += file >= 5 ? 4e-3 : 0; });
    const auto found = of_kind(m, Kind::level_change, "torque");
    ASSERT_EQ(found.size(), 1u);
    EXPECT_TRUE(found[0].offset);
    EXPECT_NEAR(found[0].size, 4e-3, 1e-3);
}

TEST(LevelChange, IsNoSteadyTrendAndNoSingleOddRecording) {
    const auto found = [](const SpoilFile& spoil) {
        return of_kind(study_of(14, 5, {}, spoil), Kind::level_change);
    };
    EXPECT_THAT(found([](RowOfStep row, int, int file) { row.torque *= 1 + 0.02 * file; }),
                IsEmpty());
    EXPECT_THAT(found([](RowOfStep row, int, int file) { row.torque *= file == 13 ? 1.2 : 1; }),
                IsEmpty());
}

/// Readings of 12 files at 12 normal stresses that are never repeated, with a stress ratio that
/// depends smoothly on them, `change` times larger from the eighth file on.
std::vector<Reading> without_repetition(double change, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    std::vector<Reading> readings;
    for (int k = 0; k < 12; ++k) {
        Reading r;
        r.origin.file = fmt::format("{:02}.csv", k);
        r.condition = {.normal_stress = 300 * std::pow(1.2, (5 * k) % 12), .inertial_number = 0.01};
        r.condition.time = k;
        r.value = {0.3 * r.condition.normal_stress *
                       (1 + 0.02 * std::log(r.condition.normal_stress / 1e3)) *
                       (k >= 7 ? change : 1) * (1 + 0.01 * normal(random)),
                   0.6 * (1 + 0.002 * normal(random))};
        readings.push_back(r);
    }
    return readings;
}

TEST(LevelChange, IsSeenAgainstASmoothTrendToo) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        const auto changed = level_change_tests(without_repetition(1.1, seed), ordinary_cell);
        EXPECT_LT(changed.at(0).p, 2e-3) << seed;
        EXPECT_EQ(changed.at(0).files.front(), "07.csv");
        const auto ordinary = level_change_tests(without_repetition(1, seed), ordinary_cell);
        EXPECT_GT(ordinary.at(0).p, 2e-3) << seed;
    }
}

TEST(Saturation, OfATorqueThatIsCutOffSetsReadingsAside) {
    // The torque of the third step is about 90 mN m; its noise is cut off at 91.
    const auto clip = [](RowOfStep row, int, int) { row.torque = std::min(row.torque, 0.091); };
    const Measurements m = study_of(3, 1, {}, clip);
    EXPECT_THAT(of_kind(m, Kind::saturation, "torque"),
                testing::AllOf(testing::SizeIs(3), Each(Field(&Remark::step, 3)),
                               Each(Field(&Remark::corrected, true))));
    EXPECT_EQ(m.readings.size(), 6u);
    expect_told(told_of(m));
    const Measurements kept = study_of(3, 1, {}, clip, "[import]\nkeep_implausible = true\n");
    EXPECT_EQ(kept.readings.size(), 9u);
    EXPECT_EQ(kept.doubts().at(0).outcome, Remark::Outcome::kept);
}

TEST(Saturation, OfWholeStepsIsFoundThoughTheyHaveNoNoise) {
    const Measurements m = study_of(
        3, 1, {}, [](RowOfStep row, int, int) { row.torque = std::min(row.torque, 0.06); });
    EXPECT_THAT(of_kind(m, Kind::saturation), testing::SizeIs(testing::Ge(3)));
    EXPECT_EQ(m.readings.size(), 6u);
}

TEST(Saturation, OfShortPeaksIsNoSpike) {
    int row_number = 0;
    const Measurements m = study_of(1, 1, {}, [&](RowOfStep row, int, int) {
        if (++row_number % 60 == 0) row.torque = 0.2;
    });
    ASSERT_FALSE(of_kind(m, Kind::saturation).empty());
    expect_told(told_of(m));
}

TEST(Saturation, IsNoSmoothPeakNoCoarseColumnAndNoSpike) {
    Recording smooth = ordinary_recording("smooth.csv", 1, {.torque = 0, .force = 0, .gap = 0});
    EXPECT_THAT(saturations(smooth, recorded_steps(smooth)), IsEmpty());
    Recording wave = ordinary_recording(
        "wave.csv", 1, {.torque = 0, .force = 0, .gap = 0, .filling = 0, .step = 0},
        [](RowOfStep row, int step) {
            row.torque = 0.03 * (step + 1) * (1 + 0.05 * std::sin(2 * M_PI * row.time / 20));
        });
    EXPECT_THAT(saturations(wave, recorded_steps(wave)), IsEmpty());
    Recording coarse = ordinary_recording("coarse.csv", 1, {.torque_resolution = 2e-3});
    EXPECT_THAT(saturations(coarse, recorded_steps(coarse)), IsEmpty());
    Recording spiked = ordinary_recording("spiked.csv", 1);
    for (std::size_t k = 100; k < 1300; k += 100)
        spiked.torque[k] *= 5;
    EXPECT_THAT(saturations(spiked, recorded_steps(spiked)), IsEmpty());
    // An overflow of the converter, three times for one row.
    Recording equal = ordinary_recording("equal.csv", 1);
    for (const std::size_t k : {100u, 300u, 500u})
        equal.torque[k] = 9.99;
    EXPECT_THAT(saturations(equal, recorded_steps(equal)), IsEmpty());
}

TEST(StickSlip, IsASawtoothOfTheTorque) {
    for (const double period : {2.0, 4.0}) {
        const auto sawtooth = [&](RowOfStep row, int, int) {
            row.torque *= 1 + 0.1 * (std::fmod(row.time, period) / period - 0.5);
        };
        const Measurements m = study_of(2, 1, {.torque = 0.005}, sawtooth);
        const auto found = of_kind(m, Kind::stick_slip);
        ASSERT_EQ(found.size(), 6u) << period;
        for (const Remark& each : found) {
            EXPECT_NEAR(each.period, period, 0.1 * period);
            EXPECT_NEAR(each.relative, 0.09, 0.02);
        }
    }
    std::vector<double> mirrored, wave;
    for (int k = 0; k < 400; ++k) {
        mirrored.push_back(-(k % 20));
        wave.push_back(std::sin(0.3 * k));
    }
    EXPECT_GT(slips(mirrored, 0)->p, 0.5);
    EXPECT_GT(slips(wave, 0)->p, 0.01);
}

TEST(Drift, IsATrendInOneSenseThroughManySteps) {
    const Measurements m =
        study_of(4, 1, {}, [](RowOfStep row, int, int) { row.gap *= 1 - 0.003 * row.time / 90; });
    const auto found = of_kind(m, Kind::drift, "height");
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0].relative, -0.003, 3 * found[0].relative_error);
    EXPECT_EQ(found[0].count, 12u);
    const Measurements mixed = study_of(4, 1, {}, [](RowOfStep row, int step, int file) {
        row.gap *= 1 + ((step + file) % 2 ? 0.003 : -0.003) * row.time / 90;
    });
    EXPECT_THAT(of_kind(mixed, Kind::drift), IsEmpty());
}

TEST(Drift, HasOneSenseInMostSteps) {
    std::vector<StepTrend> trends;
    for (int step = 1; step <= 100; ++step)
        trends.push_back({"torque",
                          "run.csv",
                          step,
                          {.mean = 1,
                           .change = step % 5 < 3 ? 1e-3 : -2e-4,
                           .change_error = 1e-4,
                           .freedom = 50}});
    EXPECT_EQ(drift_tests(trends, {}).at(0).p, 1);
    for (StepTrend& trend : trends)
        trend.course.change = std::abs(trend.course.change);
    EXPECT_LT(drift_tests(trends, {}).at(0).p, 1e-6);
}

TEST(RunIn, ThatIsNotFinishedAtTheEndOfTheStepIsFound) {
    const Measurements m = study_of(3, 1, {.torque = 0.01}, [](RowOfStep row, int, int) {
        row.torque *= 1 + 0.6 * std::exp(-row.time / 30);
    });
    const auto found = of_kind(m, Kind::unfinished_run_in, "torque");
    ASSERT_GE(found.size(), 6u);
    for (const Remark& each : found)
        EXPECT_NEAR(each.relative, 0.6 * std::exp(-3), 0.03);
}

TEST(FindingSentences, FoldEqualFindingsOfManyFiles) {
    std::vector<Remark> findings;
    for (const char* const file : {"a/1.csv", "a/2.csv"})
        findings.push_back({.kind = Kind::wobble,
                            .quantity = "torque",
                            .files = {file},
                            .step = 2,
                            .size = 1e-3,
                            .relative = 0.02,
                            .period = 1,
                            .p = 1e-9});
    EXPECT_THAT(sentences(findings),
                testing::ElementsAre("Wobble: the torque varies by +-1 mN m (2 %) once per turn of "
                                     "the lid in 2 steps of 2 files, first step 2 of 1.csv (p < "
                                     "0.001)."));
    EXPECT_EQ(sentences(findings, true).size(), 2u);
}

}  // namespace pendular::data_findings_test
