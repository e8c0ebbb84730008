#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "data/recordings/measurements.h"
#include "data/recordings/step_series.h"
#include "data/remarks/wording.h"
#include "data/study/study.h"
#include "tests/support/golden.h"
#include "tests/support/ordinary_studies.h"

namespace pendular::data_measurements_test {

/// A recording of 200 rows at 5 N, its torque scaled, with 1 % noise.
std::string recording(double scale, unsigned seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    std::string text = recording_header;
    for (int i = 0; i < 200; ++i)
        text += fmt::format("{},{},5,{},0.1\n", 0.1 * i, 30 * scale * (1 + 0.01 * normal(random)),
                            4 * (1 + 0.001 * normal(random)));
    return text;
}

const std::string study_text =
    grains_table + "[liquid]\nsurface_tension = \"20.6 mN/m\"\ncontact_angle = \"0 deg\"\n" +
    cell_table("10 g") + R"([[recording]]
file = "wet_*.csv"
liquid_content = 0.03
bead_mass = "11 g"
[[recording]]
file = "dry_*.csv"
liquid_content = 0
)";

class ReadMeasurements : public testing::Test {
  protected:
    ReadMeasurements() {
        folder_.write("study.toml", study_text);
        folder_.write("dry_1.csv", recording(1, 1));
        folder_.write("dry_2.csv", recording(1.04, 2));
        folder_.write("wet_1.csv", recording(1.5, 3));
    }
    std::ptrdiff_t count_of(Remark::Kind kind) const {
        return std::ranges::count(read_measurements(read_study(folder_.path())).notes(), kind,
                                  &Remark::kind);
    }
    std::vector<std::string> notes() const {
        return texts(read_measurements(read_study(folder_.path())).notes());
    }
    TemporaryFolder folder_;
};

TEST_F(ReadMeasurements, GoesThroughTheSourcesInRunOrder) {
    const Measurements all = read_measurements(read_study(folder_.path()));
    ASSERT_EQ(all.readings.size(), 3u);
    std::vector<std::string> names;
    for (const Reading& reading : all.readings)
        names.push_back(std::filesystem::path(reading.origin.file).filename());
    EXPECT_THAT(names, testing::ElementsAre("wet_1.csv", "dry_1.csv", "dry_2.csv"));
    EXPECT_EQ(all.readings[0].condition.liquid_content, 0.03);
    // The entry's 11 g go before the cell's 10 g.
    EXPECT_NEAR(all.readings[0].value(1) / all.readings[1].value(1), 1.1, 1e-3);
}

TEST_F(ReadMeasurements, BeginWithTheFilesThatThereAre) {
    // Dry beads are measured first, wet ones later: the pattern of the wet ones matches nothing
    // yet.
    std::filesystem::remove(folder_.path() / "wet_1.csv");
    const Measurements all = read_measurements(read_study(folder_.path()));
    EXPECT_EQ(all.readings.size(), 2u);
    EXPECT_THAT(texts(all.notes()),
                testing::Contains("No file matches \"wet_*.csv\" (line 11 of study.toml): "
                                  "nothing is read for this entry."));
}

TEST_F(ReadMeasurements, LetsRecordingsFollowOneAnotherInTime) {
    // Each lasts 19.9 s from 0 on; the first two seconds or so may be left out as a transient.
    const Measurements all = read_measurements(read_study(folder_.path()));
    for (std::size_t k = 0; k < all.readings.size(); ++k) {
        const Reading& reading = all.readings[k];
        const double end = 19.9 * static_cast<double>(k + 1);
        EXPECT_NEAR(reading.condition.time, end - reading.sampled_seconds / 2, 1e-9);
    }
    EXPECT_NEAR(*all.readings[0].condition.bead_volume, 0.011 / 1050, 1e-12);
    EXPECT_NEAR(*all.readings[1].condition.bead_volume, 0.010 / 1050, 1e-12);
}

TEST_F(ReadMeasurements, AddsTheScatterBetweenReplicatesToAll) {
    // Two replicates 4 % apart: s_rep = 2.8 %, where the means are known to 0.1 %; one
    // pair knows it poorly, which widens it 6.98 times.
    const Measurements all = read_measurements(read_study(folder_.path()));
    EXPECT_EQ(all.readings[1].replicates, 2);
    for (const Reading& reading : all.readings)
        EXPECT_NEAR(std::sqrt(reading.covariance(0, 0)) / reading.value(0), 6.98 * 0.028,
                    6.98 * 0.003);
}

TEST_F(ReadMeasurements, AreTheSameAfterWritingAndReadingThem) {
    const Measurements all = read_measurements(read_study(folder_.path()));
    write_readings(folder_.path() / "readings.csv", all);
    folder_.write("study.toml", study_text.substr(0, study_text.find("[[recording]]")) +
                                    "[[readings]]\nfile = \"readings.csv\"\n");
    const Measurements back = read_measurements(read_study(folder_.path()));
    ASSERT_EQ(back.readings.size(), all.readings.size());
    for (std::size_t i = 0; i < all.readings.size(); ++i) {
        EXPECT_EQ(back.readings[i].value, all.readings[i].value);
        EXPECT_LT((back.readings[i].covariance - all.readings[i].covariance).norm(),
                  1e-9 * all.readings[i].covariance.norm());
        EXPECT_EQ(back.readings[i].replicates, all.readings[i].replicates);
        EXPECT_EQ(back.readings[i].condition.time, all.readings[i].condition.time);
        EXPECT_EQ(back.readings[i].condition.bead_volume, all.readings[i].condition.bead_volume);
    }
}

TEST_F(ReadMeasurements, ListsWhatItLeftOut) {
    folder_.write("dry_3.csv", recording_header + "0,30,5,4,0.1\n");
    const Measurements all = read_measurements(read_study(folder_.path()));
    EXPECT_EQ(all.left_out().back().last_line(), 2);
    expect_told(told_of(all));
}

TEST(Examples, PolystyreneHoldsThePublishedDryReading) {
    const Study study =
        read_study(std::filesystem::path(PENDULAR_SOURCE_DIR) / "examples" / "polystyrene");
    const Measurements all = read_measurements(study);
    ASSERT_EQ(
        std::ranges::count_if(all.readings, [](const Reading& r) { return r.condition.dry(); }), 1);
    EXPECT_EQ(all.readings.size(), 5u);  // and four wet ones
    const Reading& reading = all.readings[0];
    EXPECT_DOUBLE_EQ(reading.stress_ratio(), 0.25);
    EXPECT_DOUBLE_EQ(reading.value(1), 0.615);
    EXPECT_NEAR(std::sqrt(reading.covariance(0, 0)) / reading.condition.normal_stress, 0.02, 1e-12);
    EXPECT_NEAR(std::sqrt(reading.covariance(1, 1)), 0.002, 1e-12);
    EXPECT_TRUE(reading.condition.dry());
    EXPECT_EQ(reading.condition.inertial_number, 0);
    EXPECT_FALSE(reading.error_assumed);
    EXPECT_DOUBLE_EQ(study.liquid->viscosity, 50e-3);
}

/// Two steps, the second at twice the normal force.
std::string two_steps(double scale, unsigned seed) {
    std::string text = recording(scale, seed);
    std::istringstream rows(recording(2 * scale, seed + 1));
    std::string row;
    std::getline(rows, row);
    for (int i = 0; std::getline(rows, row); ++i) {
        row.replace(row.find(",5,"), 3, ",10,");
        text += fmt::format("{}{}\n", 0.1 * (200 + i), row.substr(row.find(',')));
    }
    return text;
}

/// The first lines of a text.
std::string first_lines(const std::string& text, int count) {
    std::size_t end = 0;
    while (count-- > 0)
        end = text.find('\n', end) + 1;
    return text.substr(0, end);
}

TEST_F(ReadMeasurements, NotesAFileThatEndsBeforeItsReplicate) {
    const std::string one = recording(1, 1);
    const std::string two = two_steps(1.01, 2);
    folder_.write("dry_1.csv", one);
    folder_.write("dry_2.csv", two);
    expect_told(notes());
    EXPECT_EQ(count_of(Remark::Kind::ends_early), 1);
    folder_.write("dry_2.csv", recording(1.01, 4));
    EXPECT_EQ(count_of(Remark::Kind::ends_early), 0);
}

TEST_F(ReadMeasurements, NotesAFileThatEndsWithinAStep) {
    folder_.write("dry_1.csv", first_lines(two_steps(1, 1), 1 + 200 + 15));
    folder_.write("dry_2.csv", two_steps(1.01, 3));
    expect_told(notes());
}

TEST_F(ReadMeasurements, NotesAFileWithoutAReading) {
    folder_.write("dry_1.csv", first_lines(recording(1, 1), 1 + 8));
    expect_told(notes());
    EXPECT_EQ(count_of(Remark::Kind::recordings_without_reading), 1);
    folder_.write("dry_1.csv", recording(1, 1));
    EXPECT_EQ(count_of(Remark::Kind::recordings_without_reading), 0);
}

/// Two steps whose angular velocities [rad/s] and gaps are multiplied by factors.
std::string faster(double factor, unsigned seed, double gap = 1) {
    std::string text;
    std::istringstream rows(two_steps(1, seed));
    for (std::string row; std::getline(rows, row);) {
        const std::size_t last = row.rfind(','), before = row.rfind(',', last - 1);
        text += row.starts_with("Time")
                    ? row + "\n"
                    : fmt::format("{},{},{}\n", row.substr(0, before),
                                  gap * std::stod(row.substr(before + 1)), 0.1 * factor);
    }
    return text;
}

TEST_F(ReadMeasurements, DoubtVelocitiesThatDifferByAFactorBetweenUnits) {
    const auto doubts = [&](double factor, double gap = 1) {
        folder_.write("dry_1.csv", faster(1, 1));
        folder_.write("dry_2.csv", faster(factor, 3, gap));
        return read_measurements(read_study(folder_.path())).doubts();
    };
    const double rpm = 30 / std::numbers::pi;
    const auto said = [](const std::vector<Remark>& found) {
        const auto doubt = std::ranges::find(found, "angular_velocity", &Remark::quantity);
        return doubt == found.end() ? std::string() : text_of(*doubt);
    };
    expect_told({said(doubts(rpm, 1.04)), said(doubts(1 / rpm, 1.04)),
                 said(doubts(2 * std::numbers::pi)), said(doubts(180 / std::numbers::pi)),
                 said(doubts(60))});
    // Ratios of ordinary speeds: a decade, with dilated beads; series of 5 and 10 for each decade.
    for (const double other : {1.0, 5.0, 6.25, 6.3, 6.3096, 9.5, 10.0})
        for (const double gap : {1.0, 1.03, 1.047})
            EXPECT_EQ(std::ranges::count(doubts(other, gap), "angular_velocity", &Remark::quantity),
                      0)
                << other;
    // The file that is alone is named, in one doubt.
    folder_.write("dry_1.csv", faster(rpm, 1));
    folder_.write("dry_2.csv", faster(1, 3));
    folder_.write("dry_3.csv", faster(1, 5));
    const auto found = read_measurements(read_study(folder_.path())).doubts();
    ASSERT_EQ(std::ranges::count(found, "angular_velocity", &Remark::quantity), 1);
    expect_told({said(found)});
}

TEST_F(ReadMeasurements, NotesAWeightOfTheGrainsThatIsNotSmall) {
    // M g/A = 0.06 kg x 9.81 m/s^2/(pi (45^2 - 21^2) mm^2) = 118 Pa, above a tenth of 5 N/A = 1
    // kPa.
    const auto weight_note = [&](const std::string& text) {
        folder_.write("study.toml", text);
        const auto notes = read_measurements(read_study(folder_.path())).notes();
        const auto note = std::ranges::find(notes, Remark::Kind::grain_weight, &Remark::kind);
        return note == notes.end() ? std::nullopt : std::optional(text_of(*note));
    };
    std::string heavy = study_text;
    for (const std::string light : {"\"10 g\"", "\"11 g\""}) {
        heavy.replace(heavy.find(light), light.size(), "\"60 g\"");
    }
    heavy += "[import]\nkeep_implausible = true\n";  // six times the beads in the same gap
    const auto note = weight_note(heavy);
    ASSERT_TRUE(note);
    expect_told({*note});
    EXPECT_FALSE(weight_note(study_text));
    EXPECT_FALSE(weight_note(heavy + "[model]\neffects = [\"grain-weight\"]\n"));
}

/// Measurements of two recordings whose rows are changed.
Measurements changed(const SpoilFile& change) {
    return study_of(2, 3, {}, change);
}

TEST(CommonReason, IsSaidOnceForAllSteps) {
    const Measurements m = changed([](RowOfStep row, int, int) { row.force = -row.force; });
    EXPECT_TRUE(m.readings.empty());
    EXPECT_TRUE(mostly_set_aside(m));
    expect_told({common_reason(m).value_or("")});
}

TEST(CommonReason, IsThatOfMostSteps) {
    const Measurements m = changed([](RowOfStep row, int step, int file) {
        if (file == 0 || step > 0) row.force = -row.force;
    });
    EXPECT_EQ(m.readings.size(), 1u);
    expect_told({common_reason(m).value_or("")});
}

TEST(CommonReason, IsNotNamedWhereMostReadingsAreKept) {
    const Measurements m = changed([](RowOfStep row, int step, int file) {
        if (file == 0 && step > 0) row.force = -row.force;
    });
    EXPECT_EQ(m.readings.size(), 4u);
    EXPECT_FALSE(mostly_set_aside(m));
    EXPECT_FALSE(common_reason(m));
}

TEST(SpeedRamp, IsASpeedThatNeverSettles) {
    std::vector<double> ramp, settled, noisy;
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal;
    for (int row = 0; row < 400; ++row) {
        ramp.push_back(0.05 * std::pow(200, row / 399.0));
        settled.push_back(1 - std::exp(-row / 40.0));
        noisy.push_back(1 + 0.3 * normal(random));
    }
    const auto found = speed_ramp(ramp);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->factor(), 200, 10);
    EXPECT_FALSE(speed_ramp(settled));
    EXPECT_FALSE(speed_ramp(noisy));
    EXPECT_FALSE(speed_ramp(std::vector<double>(400, 0)));
}

TEST(FewBeads, AreNotedOnce) {
    const auto notes_of = [](const char* diameter, const char* walls = "") {
        const TemporaryFolder folder;
        folder.write("run.csv", csv_of(ordinary_recording("", 1)));
        folder.write("study.toml",
                     fmt::format("[grains]\ndiameter = \"{}\"\ndensity = \"1050 kg/m^3\"\n{}{}"
                                 "[[recording]]\nfile = \"run.csv\"\n",
                                 diameter, cell_table("20 g"), walls));
        return read_measurements(read_study(folder.path())).notes();
    };
    const auto few = notes_of("2 mm");  // 3 beads high
    EXPECT_EQ(std::ranges::count(few, Remark::Kind::few_beads, &Remark::kind), 1);
    // 24 mm between walls: the layers along them take 3 % of the torque from beads of 0.63 mm on.
    const auto in_layers = notes_of("1 mm");
    ASSERT_EQ(std::ranges::count(in_layers, Remark::Kind::few_beads, &Remark::kind), 1);
    EXPECT_EQ(std::ranges::count(notes_of("500 um"), Remark::Kind::few_beads, &Remark::kind), 0);
    // What friction of the walls would do is said where none is stated.
    for (const auto& notes : {few, in_layers, notes_of("1 mm", "wall_friction = 0.2\n")})
        expect_told(texts(notes));
}

}  // namespace pendular::data_measurements_test
