// Recordings that are copies with noise, which are no replicates.
#include "data/recordings/copies.h"

#include <cmath>
#include <random>

#include "data/recordings/measurements.h"
#include "tests/support/golden.h"
#include "tests/support/ordinary_studies.h"

namespace pendular::data_near_copies_test {

using testing::IsEmpty;
using testing::Not;

/// A recording with another 0.05 % of noise in torque and gap of each row.
Recording with_noise(Recording recording, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    for (std::size_t k = 0; k < recording.size(); ++k) {
        recording.torque[k] *= 1 + 5e-4 * normal(random);
        recording.height[k] *= 1 + 5e-4 * normal(random);
    }
    return recording;
}

class NearCopies : public testing::Test {
  protected:
    NearCopies() {
        folder_.write("1_dry.csv", csv_of(ordinary_recording("", 1)));
        folder_.write("2_dry.csv", csv_of(with_noise(ordinary_recording("", 1), 2)));
    }
    Measurements read(const std::string& import = "") {
        folder_.write("study.toml", grains_table + cell_table("20 g") +
                                        "[[recording]]\nfile = \"*_dry.csv\"\n" + import);
        return read_measurements(read_study(folder_.path()));
    }
    TemporaryFolder folder_;
};

TEST_F(NearCopies, CountOnce) {
    const Measurements all = read();
    ASSERT_EQ(all.readings.size(), 3u);
    for (const Reading& reading : all.readings) {
        EXPECT_THAT(reading.origin.file, testing::EndsWith("1_dry.csv"));
        EXPECT_TRUE(reading.error_assumed) << "nothing is repeated";
    }
    expect_told(told_of(all));
}

TEST_F(NearCopies, CountOnceBesideReplicates) {
    folder_.write("3_dry.csv", csv_of(ordinary_recording("", 3)));
    const Measurements all = read();
    EXPECT_EQ(all.readings.size(), 6u);
    std::filesystem::remove(folder_.path() / "2_dry.csv");
    const Measurements honest = read();
    ASSERT_EQ(honest.readings.size(), 6u);
    for (std::size_t k = 0; k < 6; ++k)
        EXPECT_EQ(all.readings[k].covariance, honest.readings[k].covariance);
}

TEST_F(NearCopies, AreUsedWhereTheUserSaysSo) {
    EXPECT_EQ(read("[import]\nkeep_implausible = true\n").readings.size(), 6u);
}

/// Readings of eight steps in each of some files, scattered by 0.5 % and 0.1 %, with errors within
/// the steps of a tenth of that. The last file repeats the first within a share of the scatter.
std::vector<Reading> files_with_copy(int files, double share) {
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal;
    std::vector<Reading> all;
    for (int file = 0; file < files; ++file) {
        for (int step = 0; step < 8; ++step) {
            const Eigen::Array2d scatter =
                Eigen::Array2d(0.005, 0.001) * Eigen::Array2d(normal(random), normal(random));
            Reading reading;
            reading.origin = {fmt::format("{}.csv", file), step + 2, 0};
            reading.step = step + 1;
            reading.within_run_only = true;
            reading.condition = {500 * std::pow(1.3, step), 0.01, 0, std::nullopt};
            reading.value = {0.3 * reading.condition.normal_stress, 0.6};
            reading.covariance =
                (Eigen::Array2d(5e-4, 1e-4) * reading.value.array()).square().matrix().asDiagonal();
            if (file == files - 1)
                reading.value =
                    all[static_cast<std::size_t>(step)].value.array() * (1 + share * scatter);
            else
                reading.value.array() *= 1 + scatter;
            all.push_back(reading);
        }
    }
    return all;
}

TEST(NearCopiesOfSteps, AreFoundByTheScatterOfOtherFiles) {
    // A tenth of the scatter of steps is the error within a step: its rows allow it, the other
    // files do not.
    const auto copies = [](int files, double share) {
        return std::ranges::count(near_copies(files_with_copy(files, share), {}),
                                  Remark::Kind::copied_readings, &Remark::kind);
    };
    EXPECT_EQ(copies(4, 0.15), 1);
    EXPECT_EQ(copies(2, 0.15), 0) << "there is nothing to compare with";
    EXPECT_EQ(copies(4, 1), 0);
}

TEST(NearCopiesOfSteps, ThatAreCoarseAgreeByRounding) {
    const std::vector<Reading> same = files_with_copy(2, 0.001);
    EXPECT_THAT(near_copies(same, {}), Not(IsEmpty()));
    const Remark coarse{.kind = Remark::Kind::coarse_steps, .files = {"1.csv"}};
    EXPECT_THAT(near_copies(same, {coarse}), IsEmpty());
}

TEST(NearCopiesOfSteps, AreNotTakenFromUnknownSolidFractions) {
    // The error of 0.1 of a gap that crept is no scatter that rows show.
    std::vector<Reading> creeping = files_with_copy(2, 1);
    EXPECT_THAT(near_copies(creeping, {}), IsEmpty());
    for (Reading& reading : creeping)
        reading.covariance(1, 1) = 0.01;
    EXPECT_THAT(near_copies(creeping, {}), Not(IsEmpty()));
    for (Reading& reading : creeping)
        reading.condition.gap_creep = -1e-3;
    EXPECT_THAT(near_copies(creeping, {}), IsEmpty());
}

TEST(NearCopiesOfSteps, AreSeldomSeenInHonestStudies) {
    // Of 40 studies, one false report in a thousand studies would give any with 4 %.
    EXPECT_EQ(honest_studies_with_copies(40, 90000), 0);
}

}  // namespace pendular::data_near_copies_test
