#include "data/recordings/checks.h"

#include "data/recordings/measurements.h"
#include "tests/support/golden.h"

namespace pendular::data_repair_test {

using testing::DoubleNear;
using testing::IsEmpty;
using testing::SizeIs;

const AnnularCell cup = {.inner_radius = 0.0105, .outer_radius = 0.0215, .bead_volume = 1e-5};

/// Recording of constant torque 5 mN m whose rows `damaged` show ten times as much.
Recording damaged_recording(const std::vector<std::size_t>& damaged, std::size_t rows = 30) {
    Recording recording;
    recording.file = "r.csv";
    for (std::size_t i = 0; i < rows; ++i) {
        recording.line.push_back(static_cast<int>(i) + 2);
        recording.time.push_back(static_cast<double>(i));
        recording.torque.push_back(0.005);
        recording.shear_stress.push_back(shear_stress(0.005, cup));
    }
    for (const std::size_t row : damaged)
        recording.torque[row] *= 10;
    return recording;
}

TEST(RepairTorques, TakesTheTorqueOfTheStressWhereAMarkWasLost) {
    Recording recording = damaged_recording({3, 4, 9});
    std::vector<bool> rows;
    Measurements result;
    result.remarks = decide(torques_without_mark(recording, cup, rows), false);
    repair_torques(recording, cup, rows);
    for (const double torque : recording.torque)
        EXPECT_THAT(torque, DoubleNear(0.005, 1e-12));
    ASSERT_THAT(result.doubts(), SizeIs(1));
    expect_told({text_of(result.doubts()[0])});
    EXPECT_EQ(result.doubts()[0].outcome, Remark::Outcome::kept);
}

TEST(RepairTorques, LeavesAColumnInAWrongUnitAlone) {
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < 30; ++i)
        all.push_back(i);
    Recording recording = damaged_recording(all);
    std::vector<bool> rows;
    EXPECT_THAT(torques_without_mark(recording, cup, rows), IsEmpty());
    EXPECT_EQ(std::ranges::count(rows, true), 0);
}

/// Study with a recording of half a turn a second for a minute, with 1 % noise, whose torque column
/// lost a mark in rows 151 to 170 of 300.
class DamagedStudy : public testing::Test {
  protected:
    Measurements read(const std::string& entry) {
        std::string rows =
            "Time [s],Torque [mN m],Normal force [N],Gap [mm],Angular velocity "
            "[rad/s],Shear stress [Pa]\n";
        std::mt19937_64 random(1);
        std::normal_distribution<double> noise(1, 0.01);
        for (int i = 0; i < 300; ++i) {
            const double torque = 0.005 * noise(random);
            const double shown = i >= 150 && i < 170 ? 10 * torque : torque;
            rows += std::to_string(0.2 * i) + "," + std::to_string(1e3 * shown) + ",1.1,15,3," +
                    std::to_string(shear_stress(torque, cup)) + "\n";
        }
        folder_.write("run.csv", rows);
        folder_.write("study.toml",
                      "[grains]\ndiameter = \"500 um\"\ndensity = \"2500 kg/m^3\"\n[cell]\n"
                      "inner_radius = \"10.5 mm\"\nouter_radius = \"21.5 mm\"\nbead_mass = "
                      "\"24.9 g\"\n[[recording]]\nfile = \"run.csv\"\n" +
                          entry);
        return read_measurements(read_study(folder_.path()));
    }
    TemporaryFolder folder_;
};

TEST_F(DamagedStudy, LeavesDamagedRowsOutUnlessTheyAreToBeRepaired) {
    const Measurements without = read("");
    EXPECT_THAT(without.readings, IsEmpty());
    const Measurements repaired = read("repair = true\n");
    ASSERT_THAT(repaired.readings, SizeIs(1));
    EXPECT_NEAR(repaired.readings[0].value(0), shear_stress(0.005, cup), 1);
}

}  // namespace pendular::data_repair_test
