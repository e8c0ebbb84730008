#include "data/recordings/checks.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "data/quantities/number.h"
#include "data/recordings/measurements.h"
#include "tests/support/golden.h"

namespace pendular::data_contradictions_test {

using testing::IsEmpty;

const AnnularCell cell{.inner_radius = 0.021, .outer_radius = 0.045, .bead_volume = 0.02 / 1050};

/// 200 rows of 16 strains at 5 N and 30 mN m with 1 % of noise, and what follows from them.
Recording measured() {
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal;
    Recording recording;
    recording.file = "run.csv";
    for (int i = 0; i < 200; ++i) {
        recording.line.push_back(i + 2);
        recording.time.push_back(0.1 * i);
        recording.torque.push_back(0.03 * (1 + 0.01 * normal(random)));
        recording.normal_force.push_back(5 * (1 + 0.01 * normal(random)));
        recording.height.push_back(6.3e-3 * (1 + 0.001 * normal(random)));
        recording.angular_velocity.push_back(0.1);
        recording.shear_stress.push_back(shear_stress(recording.torque.back(), cell));
        recording.normal_stress.push_back(normal_stress(recording.normal_force.back(), cell));
        recording.shear_rate.push_back(shear_rate(0.1, recording.height.back(), cell));
    }
    return recording;
}

/// Remarks on a recording, decided; contradicting rows are taken out.
Measurements compared(Recording& recording, bool keep_implausible = false) {
    std::vector<bool> rows;
    Measurements said;
    said.remarks = decide(contradictions(recording, cell, rows), keep_implausible);
    if (!keep_implausible) recording.erase_rows(rows);
    return said;
}

void scale(std::vector<double>& values, double factor) {
    for (double& value : values)
        value *= factor;
}

TEST(Contradictions, AreNoneWhereColumnsAgree) {
    Recording recording = measured();
    scale(recording.normal_stress, -1);  // another convention of sign
    recording.shear_stress[7] = std::numeric_limits<double>::quiet_NaN();
    const Measurements said = compared(recording);
    EXPECT_THAT(said.doubts(), IsEmpty());
    EXPECT_THAT(said.notes(), IsEmpty());
    EXPECT_EQ(recording.size(), 200u);
}

TEST(Contradictions, NameACommonFactor) {
    const auto said = [](double factor, std::vector<double> Recording::*column) {
        Recording recording = measured();
        scale(recording.*column, factor);
        const Measurements found = compared(recording);
        EXPECT_EQ(found.doubts().size(), 1u);
        EXPECT_EQ(found.doubts().at(0).kind, Remark::Kind::wrong_factor);
        EXPECT_EQ(found.doubts().at(0).outcome, Remark::Outcome::set_aside);
        return text_of(found.doubts().at(0));
    };
    expect_told({said(2, &Recording::shear_stress), said(1000, &Recording::shear_stress),
                 said(1.3, &Recording::normal_stress), said(2 * M_PI, &Recording::shear_rate)});
}

TEST(Contradictions, LeaveRatesAtOtherRadiiToANote) {
    Recording recording = measured();
    scale(recording.shear_rate, 1.36);  // at the rim
    const Measurements said = compared(recording);
    EXPECT_THAT(said.doubts(), IsEmpty());
    expect_told({text_of(said.notes().at(0))});
}

TEST(Contradictions, OfSomeRowsTakeThemOut) {
    // A thousands separator was eaten: 40 torques are ten times too large.
    Recording recording = measured();
    for (std::size_t i = 50; i < 90; ++i)
        recording.torque[i] *= 10;
    Recording kept = recording;
    const Measurements said = compared(recording);
    ASSERT_EQ(said.doubts().size(), 1u);
    EXPECT_EQ(said.doubts()[0].quantity, "shear_stress");
    expect_told({text_of(said.doubts()[0])});
    EXPECT_EQ(recording.size(), 160u);
    ASSERT_EQ(said.left_out().size(), 1u);
    EXPECT_EQ(said.left_out()[0].first_line(), 52);
    EXPECT_EQ(said.left_out()[0].last_line(), 91);
    EXPECT_EQ(compared(kept, true).doubts().at(0).outcome, Remark::Outcome::kept);
    EXPECT_EQ(kept.size(), 200u);
}

TEST(Contradictions, SpoilTheReadingsTheyAreIn) {
    Reading spoilt, fine, hardly;
    spoilt.origin.line = 2, spoilt.last_line = 101;
    fine.origin.line = 102, fine.last_line = 201;
    hardly.origin.line = 202, hardly.last_line = 401;
    std::vector<Reading> readings = {spoilt, fine, hardly};
    Remark rows{.kind = Remark::Kind::contradicting_rows, .outcome = Remark::Outcome::set_aside};
    rows.because = {{.lines = {{50, 51}, {300, 300}}}};
    const auto marks = set_spoilt_aside(readings, {rows}, 1);
    ASSERT_EQ(readings.size(), 2u);
    EXPECT_EQ(readings[0].origin.line, 102);
    expect_told({text_of(marks.at(0))});
    const Remark column{.kind = Remark::Kind::wrong_factor,
                        .outcome = Remark::Outcome::set_aside,
                        .quantity = "shear_stress"};
    EXPECT_EQ(set_spoilt_aside(readings, {column}, 1).size(), 2u);
    EXPECT_THAT(readings, IsEmpty());
}

class ContradictoryStudy : public testing::Test {
  protected:
    Measurements read(const std::string& more_header, const std::string& more_cells) {
        std::string text =
            "Time [s],Torque [mN m],Normal force [N],Gap [mm],Angular velocity [rad/s]" +
            more_header + "\n";
        const Recording r = measured();
        for (std::size_t i = 0; i < r.size(); ++i)
            text += fmt::format("{},{},{},{},0.1{}\n", r.time[i], 1e3 * r.torque[i],
                                r.normal_force[i], 1e3 * r.height[i],
                                fmt::format(fmt::runtime(more_cells), r.shear_stress[i]));
        folder_.write("run.csv", text);
        folder_.write("study.toml",
                      grains_table + cell_table("20 g") + "[[recording]]\nfile = \"run.csv\"\n");
        return read_measurements(read_study(folder_.path()));
    }
    TemporaryFolder folder_;
};

TEST_F(ContradictoryStudy, SetsItsReadingsAside) {
    EXPECT_EQ(read(",Shear stress [Pa]", ",{}").readings.size(), 1u);
    const Measurements twice = read(",Shear stress [mPa]", ",{}");
    EXPECT_THAT(twice.readings, IsEmpty());
    EXPECT_EQ(twice.doubts().size(), 1u);
}

TEST_F(ContradictoryStudy, DoesNotMindColumnsItCannotRead) {
    EXPECT_EQ(read(",Shear stress", ",{}").readings.size(), 1u);
    EXPECT_EQ(read(",Shear stress [Pa]", ",n/a {}").readings.size(), 1u);
    EXPECT_EQ(read(",Shear stress [Pa],Tau [Pa]", ",{},2").readings.size(), 1u);
}

/// Measurements of a study of one published recording, with lines of its [[recording]] in `more`.
Measurements of_published(const std::filesystem::path& file, const std::string& diameter,
                          const std::string& more = "") {
    const TemporaryFolder folder;
    std::filesystem::copy_file(file, folder.path() / "run.csv");
    folder.write("study.toml",
                 "[grains]\ndiameter = \"" + diameter +
                     "\"\ndensity = \"2500 kg/m^3\"\n[cell]\ninner_radius = \"10.5 mm\"\n"
                     "outer_radius = \"21.5 mm\"\nbead_mass = \"27.9 g\"\n[[recording]]\n"
                     "file = \"run.csv\"\n" +
                     more);
    return read_measurements(read_study(folder.path()));
}

TEST(PublishedRecordings, AreNotBelievedWhereTheFillingCannotBe) {
    const auto file = published_sample("antonpaar_powder/jank_flat_glass420_w10_3kPa.csv");
    if (!file) GTEST_SKIP() << "PENDULAR_SAMPLES is not set";
    const Measurements all = of_published(*file, "420 um");
    EXPECT_THAT(all.readings, IsEmpty());
    const auto doubts = all.doubts();
    const auto filling = std::ranges::find(doubts, "solid_fraction", &Remark::quantity);
    ASSERT_NE(filling, doubts.end());
    EXPECT_GT(filling->size, filling->limit);  // denser than spheres can be packed
}

TEST(PublishedRecordings, AreNotBelievedWhereTorquesAreCorrupt) {
    const auto file =
        published_sample("antonpaar_powder/jank_flat_glass230_original_3kPa_CORRUPT_TORQUE.csv");
    if (!file) GTEST_SKIP() << "PENDULAR_SAMPLES is not set";
    const Measurements all = of_published(
        *file, "230 um",
        "columns = [\"Point [1]\", \"Time [s]\", \"Gap [mm]\", \"Normal force [N]\", "
        "\"Normal stress [Pa]\", \"Torque [mN m]\", \"Shear stress [Pa]\", \"Speed [1/min]\"]\n");
    EXPECT_THAT(all.doubts(), testing::Contains(testing::Field(&Remark::quantity, "shear_stress")));
}

}  // namespace pendular::data_contradictions_test
