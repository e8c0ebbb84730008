// The file that deviates from a model in another way than all others: found where one does, rarely
// named where none does.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "analysis/misfit/odd_file.h"

namespace pendular::odd_file_test {

/// Readings of files in steps, whose true values are the predicted ones.
struct Rig {
    std::size_t files = 4, steps = 6;
    double between = 0.001, within = 0.002;  ///< scatter of the solid fraction, relative [1]
    std::mt19937_64 random{5};

    /// Readings with the solid fraction of the last file shifted [1].
    std::vector<Reading> readings(double shift) {
        std::normal_distribution<double> normal;
        std::vector<Reading> all;
        for (std::size_t f = 0; f < files; ++f) {
            const double of_file = between * normal(random) + (f + 1 == files ? shift : 0);
            for (std::size_t k = 0; k < steps; ++k) {
                Reading reading;
                reading.origin = {"run_" + std::to_string(f) + ".csv", 1};
                reading.condition.height = 0.02;
                reading.value << 300 * (1 + 0.01 * normal(random)),
                    0.6 * (1 + of_file + within * normal(random));
                all.push_back(reading);
            }
        }
        return all;
    }
    Eigen::VectorXd predicted() const {
        return Eigen::Vector2d(300, 0.6).replicate(static_cast<Eigen::Index>(files * steps), 1);
    }
    /// Shares of studies in which some file stands out, and in which one is named.
    std::pair<double, double> named(double shift, int studies) {
        int out = 0, some = 0;
        for (int k = 0; k < studies; ++k) {
            const auto odd = odd_file(readings(shift), predicted());
            out += odd && odd->stands_out();
            some += odd && odd->worth_a_look();
        }
        return {out / double(studies), some / double(studies)};
    }
};

TEST(OddFile, IsRarelyNamedWhereFilesScatterAlike) {
    constexpr int studies = 2000;
    for (const std::size_t files : {3, 4, 8}) {
        // Of the scatter between fillings, nearly all or none is seen beside that within files.
        for (const double between : {0.02, 0.0}) {
            const auto [out, some] = Rig{.files = files, .between = between}.named(0, studies);
            // 5 %, and four standard deviations of the share.
            EXPECT_LT(out, 0.05 + 4 * std::sqrt(0.05 * 0.95 / studies)) << files;
            EXPECT_LT(some, 0.25 + 4 * std::sqrt(0.25 * 0.75 / studies)) << files;
            // Without scatter between fillings, the readings within files leave no doubt.
            EXPECT_LT(some, between == 0 ? 0.1 : 1) << files;
        }
    }
}

TEST(OddFile, IsNamedWhereItsGapIsShifted) {
    Rig four, eight{.files = 8};
    EXPECT_GT(four.named(0.02, 500).second, 0.8);
    EXPECT_GT(eight.named(0.02, 500).first, 0.95);
}

TEST(OddFile, SaysHowFarAndWhichGapWouldDoSo) {
    Rig rig{.files = 8};
    const auto odd = odd_file(rig.readings(-0.03), rig.predicted());
    ASSERT_TRUE(odd);
    EXPECT_TRUE(odd->stands_out());
    EXPECT_EQ(odd->file, "run_7.csv");
    EXPECT_EQ(odd->observable, 1);
    EXPECT_EQ(odd->files, 8u);
    EXPECT_NEAR(odd->deviation, -0.03, 0.004);
    EXPECT_NEAR(odd->gap_error().value(), 0.03 * 0.02, 1e-4);
    EXPECT_FALSE(odd->alone);
}

TEST(OddFile, IsNotSoughtAmongTwoFilesOrSingleReadings) {
    Rig two{.files = 2}, single{.files = 6, .steps = 1};
    EXPECT_FALSE(odd_file(two.readings(0.5), two.predicted()));
    EXPECT_FALSE(odd_file(single.readings(0.5), single.predicted()));
}

TEST(OddFile, MayBeTheModelWhereTheFileIsAloneAtItsContent) {
    Rig rig{.files = 8};
    std::vector<Reading> readings = rig.readings(0.03);
    for (Reading& reading : readings)
        reading.condition.liquid_content = reading.origin.file == "run_7.csv" ? 0.03 : 0;
    const auto odd = odd_file(readings, rig.predicted());
    ASSERT_TRUE(odd);
    EXPECT_TRUE(odd->alone);
}

}  // namespace pendular::odd_file_test
