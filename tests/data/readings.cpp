#include "data/recordings/measurements.h"

#include <fmt/format.h>

#include <cmath>
#include <random>
#include <set>

#include "data/files/csv.h"
#include "data/files/text_file.h"
#include "data/recordings/replicate_table.h"
#include "tests/support/golden.h"

namespace pendular::data_readings_test {

using testing::IsEmpty;

class ReadPoints : public testing::Test {
  protected:
    ReadPoints() {
        study_.grains = {.diameter = 500e-6, .density = 1050};
        study_.liquid = Liquid{.surface_tension = 20.6e-3};
        source_.kind = Source::Kind::readings;
        source_.liquid_content = 0;
    }
    Measurements read(const std::string& content) {
        return read_points(folder_.write("p.csv", content), source_, study_);
    }
    std::string error(const std::string& content) {
        return input_error([&] { read(content); });
    }

    TemporaryFolder folder_;
    Study study_;
    Source source_;
};

TEST_F(ReadPoints, TurnsAStressRatioIntoAShearStress) {
    const Reading reading =
        read(
            "normal_stress [kPa],stress_ratio,stress_ratio_sd,solid_fraction [%],"
            "solid_fraction_sd [%],inertial_number,height [mm],normal_stress_sd [kPa]\n"
            "2,0.25,0.02,61.5,0.2,0,4,0.1\n")
            .readings.at(0);
    EXPECT_DOUBLE_EQ(reading.value(0), 500);
    EXPECT_DOUBLE_EQ(reading.value(1), 0.615);
    // The ratio hardly depends on the normal stress: its deviation is left out.
    EXPECT_NEAR(reading.covariance(0, 0), 40 * 40, 1e-9);
    EXPECT_NEAR(reading.covariance(1, 1), 0.002 * 0.002, 1e-15);
    EXPECT_EQ(reading.condition.normal_stress, 2000);
    EXPECT_EQ(reading.condition.inertial_number, 0);
    EXPECT_EQ(reading.shear_rate, 0);
    EXPECT_TRUE(reading.condition.dry());
    EXPECT_DOUBLE_EQ(*reading.condition.height, 0.004);
    EXPECT_EQ(reading.origin.line, 2);
    EXPECT_DOUBLE_EQ(reading.stress_ratio(), 0.25);
}

TEST_F(ReadPoints, RefusesACellWithoutAValueWhereADefaultWouldCount) {
    source_.liquid_content.reset();
    const auto refused = [&](const std::string& column, const std::string& cell) {
        return error(
            "normal_stress [Pa],shear_stress [Pa],solid_fraction,inertial_number,"
            "liquid_content," +
            column + "\n1000,400,0.6,0,0.01,4\n1000,400,0.6,0," +
            (column == "humidity" ? cell + ",1" : "0.01," + cell) + "\n");
    };
    for (const std::string cell : {"NA", "NaN", "-9999"}) {
        EXPECT_THAT(refused("humidity", cell), testing::HasSubstr("p.csv:3:")) << cell;
        EXPECT_THAT(refused("humidity", cell), testing::HasSubstr('"' + cell + '"')) << cell;
        EXPECT_FALSE(refused("height [mm]", cell).empty()) << cell;
        EXPECT_FALSE(refused("preshear_stress [Pa]", cell).empty()) << cell;
    }
    // An error may be unknown.
    EXPECT_NO_THROW(
        read("normal_stress [Pa],shear_stress [Pa],solid_fraction,inertial_number,"
             "liquid_content,shear_stress_se [Pa]\n1000,400,0.6,0,0.01,NA\n"));
}

TEST_F(ReadPoints, ShowsTheTextOfANeededCellWithoutAValue) {
    expect_told(
        {error("normal_stress [Pa],shear_stress [Pa],solid_fraction,inertial_number\n"
               "1000,NaN,0.6,0\n")});
}

TEST_F(ReadPoints, TakesShearStressAndRate) {
    source_.liquid_content.reset();
    const Reading reading =
        read(
            "liquid_content,shear_rate [1/s],normal_stress [Pa],normal_stress_sd [Pa],"
            "shear_stress [Pa],shear_stress_sd [Pa],solid_fraction\n0.03,2,1000,40,300,5,0.6\n")
            .readings.at(0);
    EXPECT_EQ(reading.condition.liquid_content, 0.03);
    EXPECT_EQ(reading.shear_rate, 2);
    EXPECT_DOUBLE_EQ(reading.condition.inertial_number, inertial_number(2, 1000, study_.grains));
    // 5 Pa of its own and 0.3 times 40 Pa of the normal stress.
    EXPECT_NEAR(reading.covariance(0, 0), 5 * 5 + 12 * 12, 1e-9);
}

TEST_F(ReadPoints, TellsThreeMeaningsOfAStatedErrorApart) {
    const auto errors = [&](const std::string& columns, const std::string& cells) {
        const Measurements all =
            read("normal_stress [Pa],shear_stress [Pa],solid_fraction,inertial_number," + columns +
                 "\n1000,300,0.6,0.01," + cells + "\n");
        return Eigen::Vector2d(all.readings.at(0).covariance.diagonal().cwiseSqrt());
    };
    const Eigen::Vector2d expected(6, 0.003);
    const auto expect = [&](const Eigen::Vector2d& found) {
        EXPECT_NEAR(found(0), expected(0), 1e-9);
        EXPECT_NEAR(found(1), expected(1), 1e-12);
    };
    expect(errors("shear_stress_se [Pa],solid_fraction_se", "6,0.003"));
    expect(errors("shear_stress_sd [Pa],solid_fraction_sd", "6,0.003"));
    // The mean of n values has the standard error sd/sqrt(n).
    expect(errors("shear_stress_sd [Pa],shear_stress_n,solid_fraction_sd,solid_fraction_n",
                  "18,9,0.006,4"));
    // 95 % of a normal distribution lie within 1.959964 standard deviations of its mean.
    expect(errors("shear_stress_u95 [Pa],solid_fraction_u95", "11.759784,0.005879892"));
}

TEST_F(ReadPoints, SaysThatADeviationWithoutNumberIsAStandardError) {
    const std::string columns =
        "normal_stress [Pa],shear_stress [Pa],solid_fraction,"
        "inertial_number,shear_stress_sd [Pa]";
    const Measurements alone = read(columns + "\n1000,300,0.6,0.01,6\n");
    ASSERT_EQ(alone.notes().size(), 1u);
    EXPECT_EQ(alone.notes()[0].kind, Remark::Kind::sd_read_as_standard_error);
    expect_told({text_of(alone.notes()[0])});
    EXPECT_THAT(read(columns + ",shear_stress_n\n1000,300,0.6,0.01,6,4\n").notes(), IsEmpty());
}

TEST_F(ReadPoints, AsksAboutATableInWhichNothingFlows) {
    source_.liquid_content = 0;
    const auto notes = [&](const std::string& column, const std::string& one,
                           const std::string& other) {
        const Measurements all = read(
            fmt::format("normal_stress [Pa],shear_stress [Pa],solid_fraction,{}\n1000,300,0.6,{}\n"
                        "2000,600,0.6,{}\n",
                        column, one, other));
        std::vector<std::string> texts;
        for (const Remark& note : all.notes())
            texts.push_back(text_of(note));
        return texts;
    };
    const auto zeros = notes("inertial_number", "0", "0");
    const auto slow = notes("shear_rate [1/s]", "2e-4", "2e-4");
    ASSERT_EQ(zeros.size(), 1u);
    ASSERT_EQ(slow.size(), 1u);
    expect_told({zeros[0], slow[0]});
    EXPECT_THAT(notes("inertial_number", "0", "0.01"), IsEmpty());
    EXPECT_THAT(notes("shear_rate [1/s]", "2e-4", "2"), IsEmpty());
}

TEST_F(ReadPoints, RefusesErrorsThatAreStatedTwiceOrInPart) {
    const auto refused = [&](const std::string& columns, const std::string& cells) {
        return error("normal_stress [Pa],shear_stress [Pa],solid_fraction,inertial_number," +
                     columns + "\n1000,300,0.6,0.01," + cells + "\n");
    };
    expect_told({refused("shear_stress_sd [Pa],shear_stress_se [Pa]", "6,6"),
                 refused("solid_fraction_se,solid_fraction_u95", "0.003,0.006"),
                 refused("shear_stress_n", "9"),
                 refused("shear_stress_se [Pa],shear_stress_n", "6,9"),
                 refused("shear_stress_sd [Pa],shear_stress_n", "6,1"),
                 refused("shear_stress_sd [Pa],shear_stress_n", "6,"),
                 refused("shear_stress_u95 [Pa]", "0"), refused("stress_ratio_se", "0.003"),
                 refused("bulk_density_sd [kg/m^3]", "3")});
}

TEST_F(ReadPoints, MarksErrorsThatAreNotStated) {
    const Reading reading =
        read(
            "normal_stress [Pa],normal_stress_sd [Pa],shear_stress [Pa],solid_fraction,"
            "solid_fraction_sd,inertial_number\n1000,40,300,0.6,0.003,0.01\n")
            .readings.at(0);
    // The error of the normal stress is not that of the shear stress.
    EXPECT_TRUE(reading.unstated[0]);
    EXPECT_FALSE(reading.unstated[1]);
    EXPECT_NEAR(reading.covariance(0, 0), 12 * 12, 1e-9);
}

TEST_F(ReadPoints, AcceptsTheInertialNumberOfTheOtherConvention) {
    const double rate = 2;
    const double other = rate * 500e-6 * std::sqrt(1050 / 1000.0);
    const Reading reading = read(fmt::format("normal_stress [Pa],stress_ratio,solid_fraction,"
                                             "inertial_number_diameter_density\n1000,0.3,0.6,{}\n",
                                             other))
                                .readings.at(0);
    EXPECT_NEAR(reading.condition.inertial_number, inertial_number(rate, 1000, study_.grains),
                1e-12);
}

TEST_F(ReadPoints, RefusesAnInertialNumberThatDoesNotGoWithTheShearRate) {
    const double other = 2 * 500e-6 * std::sqrt(1050 / 1000.0);
    expect_told(
        {error(fmt::format("normal_stress [Pa],stress_ratio,solid_fraction,shear_rate [1/s],"
                           "inertial_number\n1000,0.3,0.6,2,{}\n",
                           other))});
}

const std::string head = "normal_stress [Pa],stress_ratio,solid_fraction,inertial_number";

TEST_F(ReadPoints, RefusesMissingColumns) {
    expect_told({error("stress_ratio\n1\n"), error("normal_stress [Pa]\n1\n"),
                 error("normal_stress [Pa],stress_ratio\n1,1\n"),
                 error("normal_stress [Pa],stress_ratio,solid_fraction\n1,1,1\n"),
                 error(head + ",shear_stress [Pa]\n1,1,1,1,1\n")});
    source_.liquid_content.reset();
    expect_told({error(head + "\n1000,0.3,0.6,0\n")});
}

TEST_F(ReadPoints, RefusesAMisspeltColumnButNotARemark) {
    expect_told({error(head + ",solid_fractoin_sd\n1000,0.3,0.6,0,0.01\n"),
                 text_of(read(head + ",Remark\n1000,0.3,0.6,0.01,fine\n").notes().at(0))});
}

TEST_F(ReadPoints, RefusesImpossibleValues) {
    const auto row_error = [&](const std::string& row) { return error(head + "\n" + row + "\n"); };
    expect_told({row_error("0,0.3,0.6,0"), row_error("1000,-0.3,0.6,0"), row_error("1000,0.3,0,0"),
                 row_error("1000,0.3,0.6,-1"), row_error("1000,0.3,0.6,"), row_error("1000,,0.6,0"),
                 error(head + ",height [m]\n1000,0.3,0.6,0,-1\n"),
                 error("normal_stress [Pa],stress_ratio,solid_fraction,shear_rate [1/s]\n"
                       "1000,0.3,0.6,0\n"),
                 error(head + ",error_correlation\n1000,0.3,0.6,0,1\n")});
}

TEST_F(ReadPoints, RefusesALiquidContentThatDoesNotFitTheStudy) {
    expect_told({error(head + ",liquid_content\n1000,0.3,0.6,0,0\n")});
    source_.liquid_content.reset();
    expect_told({error(head + ",liquid_content\n1000,0.3,0.6,0,-1\n")});
    study_.liquid.reset();
    expect_told({error(head + ",liquid_content\n1000,0.3,0.6,0,0.03\n")});
    EXPECT_NO_THROW(read(head + "\n1000,0.3,0.6,0\n"));  // a dry study needs none
}

TEST_F(ReadPoints, KnowsTheCellAsFarAsItIsTold) {
    const std::string row = "\n1000,0.3,0.6,0.01";
    const auto condition = [&](const std::string& columns, const std::string& cells) {
        return read(head + columns + row + cells + "\n").readings.at(0).condition;
    };
    EXPECT_EQ(condition("", "").height, std::nullopt);
    EXPECT_EQ(condition("", "").bead_volume, std::nullopt);
    EXPECT_EQ(condition("", "").time, 0);
    EXPECT_EQ(condition(",Time [min]", ",2").time, 120);
    source_.bead_volume = 2e-5;
    EXPECT_EQ(condition("", "").bead_volume, 2e-5);
    EXPECT_EQ(condition("", "").height, std::nullopt);
    study_.cell = AnnularCell{.inner_radius = 0.021, .outer_radius = 0.045, .bead_volume = 3e-5};
    // The entry goes before the cell, the column before both.
    EXPECT_EQ(condition("", "").bead_volume, 2e-5);
    EXPECT_DOUBLE_EQ(*condition("", "").height, 2e-5 / (0.6 * study_.cell->area()));
    EXPECT_DOUBLE_EQ(*condition(",bead_volume [cm^3]", ",10").bead_volume, 1e-5);
    EXPECT_DOUBLE_EQ(*condition(",height [mm]", ",7").height, 7e-3);
    source_.bead_volume.reset();
    EXPECT_EQ(condition("", "").bead_volume, 3e-5);
    expect_told({error(head + ",bead_volume [cm^3]" + row + ",-1\n")});
}

Measurements some_readings() {
    Measurements some;
    std::mt19937_64 random(9);
    std::uniform_real_distribution<double> uniform(0.5, 1.5);
    for (int i = 0; i < 20; ++i) {
        Reading reading;
        reading.origin = {"folder/some, file.csv", i + 2, 0};
        reading.step = i % 3;
        reading.condition = {1000 * uniform(random), i % 4 ? 0.01 * uniform(random) : 0,
                             i % 2 ? 0.03 : 0, std::nullopt};
        if (i % 5) reading.condition.height = 0.01 * uniform(random);
        if (i % 3) reading.condition.bead_volume = 1e-5 * uniform(random);
        reading.condition.time = i * 100 * uniform(random);
        reading.value = {300 * uniform(random), 0.6 * std::min(uniform(random), 1.2)};
        const double a = 3 * uniform(random), b = 0.01 * uniform(random);
        reading.covariance << a * a, -0.4 * a * b, -0.4 * a * b, b * b;
        reading.sampled_seconds = i % 3 ? 30 * uniform(random) : 0;
        reading.error_assumed = i == 7;
        some.readings.push_back(reading);
    }
    return some;
}

TEST_F(ReadPoints, ReadsWhatWasWritten) {
    source_.liquid_content.reset();
    const Measurements written = some_readings();
    const std::filesystem::path path = folder_.path() / "out" / "readings.csv";
    write_readings(path, written);
    const Measurements back = read_points(path, source_, study_);
    EXPECT_THAT(back.notes(), IsEmpty());
    ASSERT_EQ(back.readings.size(), written.readings.size());
    for (std::size_t i = 0; i < written.readings.size(); ++i) {
        const Reading& a = written.readings[i];
        const Reading& b = back.readings[i];
        EXPECT_EQ(a.value, b.value);
        EXPECT_LT((a.covariance - b.covariance).norm(), 1e-12 * a.covariance.norm());
        EXPECT_EQ(a.condition.normal_stress, b.condition.normal_stress);
        EXPECT_EQ(a.condition.inertial_number, b.condition.inertial_number);
        EXPECT_EQ(a.condition.liquid_content, b.condition.liquid_content);
        EXPECT_EQ(a.condition.height, b.condition.height);
        EXPECT_EQ(a.condition.bead_volume, b.condition.bead_volume);
        EXPECT_EQ(a.condition.time, b.condition.time);
        EXPECT_EQ(a.sampled_seconds, b.sampled_seconds);
        EXPECT_EQ(a.error_assumed, b.error_assumed);
        EXPECT_EQ(a.step, b.step);
    }
}

/// Three fillings at five normal stresses, which differ by 1.2 % besides a scatter of 0.3 % from
/// step to step, pooled.
Measurements three_fillings() {
    Measurements all;
    std::mt19937_64 random(4);
    std::normal_distribution<double> normal;
    for (int file = 0; file < 3; ++file) {
        const double shift = 0.012 * normal(random);
        for (int step = 0; step < 5; ++step) {
            Reading reading;
            reading.origin = {fmt::format("dry_{}.csv", file), step + 2, 0};
            reading.condition = {500.0 * (step + 1), 0.01, 0, std::nullopt};
            reading.value = {
                0.3 * reading.condition.normal_stress * (1 + shift + 0.003 * normal(random)),
                0.6 * (1 + 0.001 * normal(random))};
            reading.covariance = (1e-4 * reading.value).cwiseAbs2().asDiagonal();
            reading.within_run_only = true;
            all.readings.push_back(reading);
        }
    }
    pool_replicates(all);
    return all;
}

TEST_F(ReadPoints, ReadsTheErrorsOfFillingsBack) {
    const Measurements written = three_fillings();
    ASSERT_GT(written.readings[0].filling_variance()(0),
              0.5 * written.readings[0].covariance(0, 0));
    const std::filesystem::path path = folder_.path() / "out" / "readings.csv";
    write_readings(path, written);
    source_.liquid_content.reset();
    // Twice, as of two cups: fillings of different tables share nothing.
    Measurements back = read_points(path, source_, study_);
    const Measurements other =
        read_points(folder_.write("other.csv", read_text(path)), source_, study_);
    back.readings.insert(back.readings.end(), other.readings.begin(), other.readings.end());
    for (std::size_t i = 15; i < back.readings.size(); ++i)
        back.readings[i].condition.liquid_content = 0.03;  // no replicates of the first table
    EXPECT_EQ(replicate_table(back.readings).name_of(1), "readings.csv (filling 2)");
    pool_replicates(back);
    EXPECT_THAT(back.notes(), IsEmpty());
    std::set<std::size_t> sources;
    for (std::size_t i = 0; i < back.readings.size(); ++i) {
        const Reading& a = written.readings[i % 15];
        const Reading& b = back.readings[i];
        EXPECT_LT((a.covariance - b.covariance).norm(), 1e-9 * a.covariance.norm());
        EXPECT_LT((a.filling_variance() - b.filling_variance()).norm(),
                  1e-9 * a.filling_variance().norm());
        // All steps of a filling, and no others, have the source of its first step.
        EXPECT_EQ(b.shared.at(0).source, back.readings[i - i % 5].shared.at(0).source);
        sources.insert(b.shared.at(0).source);
    }
    EXPECT_EQ(sources.size(), 6u);
}

TEST_F(ReadPoints, RefusesImpossibleErrorsOfFillings) {
    const auto refused = [&](const std::string& cells) {
        return error(
            "normal_stress [Pa],shear_stress [Pa],shear_stress_se [Pa],solid_fraction,"
            "inertial_number,filling,shear_stress_of_filling [Pa]\n1000,300,6,0.6,0.01," +
            cells + "\n");
    };
    expect_told({refused("1,7"), refused("1,-2"), refused(",2"), refused("0.5,2")});
}

TEST(WriteTables, SayWhereEachReadingAndExclusionComesFrom) {
    TemporaryFolder folder;
    Measurements all;
    Reading reading;
    reading.origin = {(folder.path() / "dry.csv").string(), 12, 0};
    reading.condition.normal_stress = 1000;
    all.readings.push_back(reading);
    all.remarks.push_back({.kind = Remark::Kind::transient,
                           .outcome = Remark::Outcome::left_out,
                           .files = {(folder.path() / "dry.csv").string()},
                           .lines = {{2, 11}},
                           .step = 1,
                           .size = 3});
    write_readings(folder.path() / "out" / "readings.csv", all);
    write_excluded(folder.path() / "out" / "excluded.csv", all);
    const Table readings = read_table(folder.path() / "out" / "readings.csv");
    EXPECT_EQ(readings.rows.at(0).cells.at(13).text, "../dry.csv");
    EXPECT_EQ(readings.rows.at(0).cells.at(14).text, "12");
    const Table excluded = read_table(folder.path() / "out" / "excluded.csv");
    const std::vector<Cell>& cells = excluded.rows.at(0).cells;
    EXPECT_EQ(cells.at(0).text, "../dry.csv");
    EXPECT_EQ(cells.at(1).text, "2");
    EXPECT_EQ(cells.at(2).text, "11");
    EXPECT_EQ(cells.at(3).text, "step 1: transient of 3 s, until torque and gap are steady");
}

}  // namespace pendular::data_readings_test
