// Names and units of columns as people and instruments write them.
#include "data/files/column_names.h"
#include "data/files/header_cell.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <numbers>

#include "data/annular_cell.h"
#include "data/files/columns.h"
#include "data/files/text_file.h"
#include "data/quantities/units.h"
#include "data/recordings/file_view.h"
#include "data/recordings/measurements.h"
#include "data/recordings/recording.h"
#include "tests/support/golden.h"

namespace pendular::data_column_names_test {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

TEST(HeaderCellWithoutBrackets, HasItsUnitBehindASlashACommaOrAWord) {
    EXPECT_EQ(parts("Torque / mNm"), "Torque|mNm");
    EXPECT_EQ(parts("Torque/mNm"), "Torque|mNm");
    EXPECT_EQ(parts("Angular velocity / rad/s"), "Angular velocity|rad/s");
    EXPECT_EQ(parts("Angular velocity/rad/s"), "Angular velocity|rad/s");
    EXPECT_EQ(parts("Drehmoment, mNm"), "Drehmoment|mNm");
    EXPECT_EQ(parts("Drehmoment in mNm"), "Drehmoment|mNm");
    EXPECT_EQ(parts("Couple en mNm"), "Couple|mNm");
    EXPECT_EQ(parts("Load cell / N"), "Load cell|N");  // an unknown name
    EXPECT_EQ(parts("Time / h"), "Time|h");            // an hour, not the height
    EXPECT_EQ(parse_header_cell("Torque_sd / mNm").mark, ErrorMark::standard_deviation);
}

TEST(HeaderCellWithoutBrackets, KeepsSlashesAndCommasOfNames) {
    for (const char* const name : {"phi_L/phi_S", "shear_stress/normal_stress", "Time, sequence",
                                   "Torque / normal force", "Date/Time", "a, b", "G'/G''"})
        EXPECT_EQ(parts(name), std::string(name) + "|");
}

TEST(ColumnMeaningTest, HoldsInFiveLanguages) {
    const auto meaning = [](const char* name, const char* unit) {
        return meaning_of_column(name, unit).quantity;
    };
    for (const char* const name : {"Torque", "Drehmoment", "Couple", "Par de torsión", "Coppia"})
        EXPECT_EQ(meaning(name, "mNm"), "torque") << name;
    EXPECT_EQ(meaning("Drehzahl", "U/min"), "rotational_speed");
    EXPECT_EQ(meaning("Vitesse de rotation", "tr/min"), "rotational_speed");
    EXPECT_EQ(meaning("Numero di giri", "giri/min"), "rotational_speed");
    EXPECT_EQ(meaning("Schergeschwindigkeit", "1/s"), "shear_rate");
    EXPECT_EQ(meaning("Schergeschwindigkeit", "mm/min"), "shear_velocity");
    EXPECT_EQ(meaning("Drehmoment", "N"), "");
}

class TableOfOnesOwn : public testing::Test {
  protected:
    std::filesystem::path write(const std::string& header, const std::string& rows) {
        return folder_.write("t.csv", header + "\n" + rows);
    }
    TemporaryFolder folder_;
};

constexpr const char* semicolons =
    "0;20,1;5,0;6,20;2,0\n1;20,2;5,0;6,21;2,0\n2;20,3;5,0;6,20;2,0\n";

TEST_F(TableOfOnesOwn, IsReadInAnyLanguageAndWritingOfUnits) {
    for (const char* const header :
         {"Zeit [s];Drehmoment [mNm];Normalkraft [N];Spalt [mm];Drehzahl [1/min]",
          "Zeit in s;Drehmoment in mNm;Normalkraft in N;Spalt in mm;Drehzahl in U/min",
          "Temps (s);Couple (mN.m);Force normale (N);Entrefer (mm);Vitesse de rotation (tr/min)",
          "Zeit, s;Drehmoment, mNm;Normalkraft, N;Spalt, mm;Drehzahl, U/min",
          "Time / s;Torque / mNm;Normal force / N;Gap / mm;Speed / rpm",
          "Zeit/s;Drehmoment/mNm;Normalkraft/N;Spaltweite/mm;Drehzahl/U/min",
          "Tiempo [s];Par de torsión [mNm];Fuerza normal [N];Altura [mm];Velocidad de giro [rpm]",
          "Tempo [s];Coppia [mNm];Forza normale [N];Traferro [mm];Numero di giri [giri/min]"}) {
        const FileView view = view_of_file(write(header, semicolons));
        EXPECT_THAT(view.missing, IsEmpty()) << header;
        const Recording recording = read_recording(write(header, semicolons));
        ASSERT_EQ(recording.size(), 3u) << header;
        EXPECT_NEAR(recording.torque[1], 20.2e-3, 1e-12) << header;
        EXPECT_NEAR(recording.height[1], 6.21e-3, 1e-12) << header;
        EXPECT_NEAR(recording.angular_velocity[1], 2 * 2 * M_PI / 60, 1e-12) << header;
    }
}

TEST_F(TableOfOnesOwn, IsReadRowByRowToo) {
    const auto path = write("Zeit [s],Drehmoment / mNm,Normalkraft [N],Spalt [mm],Drehzahl [U/min]",
                            "0,20.1,5.0,6.20,2.0\n1,20.2,5.0,6.21,2.0\n2,20.3,5.0,6.20,2.0\n");
    const auto recording = quick_recording(path, {}, 1000);
    ASSERT_TRUE(recording);
    EXPECT_NEAR(recording->torque[2], 20.3e-3, 1e-12);
    EXPECT_THAT(recording->unused_columns, IsEmpty());
}

TEST_F(TableOfOnesOwn, KeepsTheColumnThatItNamesInTheProgramsWords) {
    const auto path = write(
        "Time [s],Zeit [s],Torque [mN m],Stress [Pa],Normal force [N],Gap [mm],"
        "Speed [rpm]",
        "0,9,20.1,1,5.0,6.20,2.0\n1,8,20.2,2,5.0,6.21,2.0\n");
    const Recording recording = read_recording(path);
    EXPECT_THAT(recording.time, ElementsAre(0, 1));
    EXPECT_THAT(recording.shear_stress, IsEmpty());  // "Stress" may be the normal stress
}

/// The speed v at the mean radius (Ri + Re)/2 is that of omega = 2 v/(Ri + Re).
TEST_F(TableOfOnesOwn, MayHaveTheSpeedAtTheMeanRadius) {
    const auto path =
        write("Time [s],Torque [mN m],Normal force [N],Gap [mm],Shear velocity [mm/min]",
              "0,20.1,5.0,6.20,3.0\n1,20.2,5.0,6.21,3.0\n2,20.3,5.0,6.20,3.0\n");
    EXPECT_THAT(view_of_file(path).missing, IsEmpty());
    Recording recording = read_recording(path);
    EXPECT_THAT(recording.angular_velocity, IsEmpty());
    AnnularCell cell;
    cell.inner_radius = 0.02, cell.outer_radius = 0.04;
    fill_from_stresses(recording, cell);
    ASSERT_THAT(recording.angular_velocity, SizeIs(3));
    EXPECT_NEAR(recording.angular_velocity[0], 3e-3 / 60 / 0.03, 1e-12);
}

TEST_F(TableOfOnesOwn, IsToldOfColumnsInTheUnitOfAMissingQuantity) {
    const FileView view = view_of_file(write(
        "Time [s],Reading [mN m],Normal force [N],Gap [mm],Velocity [mm/min],Stroke [mm],Room [K]",
        "0,20.1,5.0,6.20,3.0,1,300\n1,20.2,5.0,6.21,3.0,1,300\n"));
    EXPECT_THAT(view.by_unit, ElementsAre(testing::Pair("torque", "Reading [mN m]")));
    EXPECT_THAT(view.missing, ElementsAre("speed of the lid"));
    std::vector<std::string> found;  // the gap is not missing, so that a stroke is left alone
    for (const BlockColumn& column : view.candidates)
        found.push_back(column.name + " [" + column.unit + "] " + column.quantity);
    EXPECT_THAT(found, ElementsAre("Velocity [mm/min] shear_velocity"));
    const auto speed =
        write("Time [s],Torque [mN m],Normal force [N],Gap [mm],Speed [mm/min]", "0,1,1,1,1\n");
    expect_told({input_error([&] { view_of_file(speed); })});
}

/// Columns that were left alone before names of other languages and speeds were known.
TEST_F(TableOfOnesOwn, IsReadWhateverItsOtherColumnsAre) {
    const std::string rows = "0,20.1,5.0,6.20,2.0,7\n1,20.2,5.0,6.21,2.0,7\n";
    for (const char* const other :
         {"Velocity [1/s]", "Vitesse [1/s]", "Shear velocity [1/s]", "Shear speed [rpm]"}) {
        const auto path = write(
            std::string("Time [s],Torque [mN m],Normal force [N],Gap [mm],Speed [rpm],") + other,
            rows);
        EXPECT_THAT(view_of_file(path).missing, IsEmpty()) << other;
        EXPECT_NEAR(read_recording(path).angular_velocity[0], 2 * 2 * M_PI / 60, 1e-12) << other;
    }
    const auto stresses =
        write("Time [s],Shear stress [Pa],Normal stress [Pa],Gap [mm],Speed [rpm],Couple", rows);
    EXPECT_NEAR(read_recording(stresses).shear_stress[0], 20.1, 1e-12);
    const auto speeds =
        write("Zeit,Messzeit [s],Torque [mN m],Normal force [N],Gap [mm],Speed [rpm]",
              "9,0,20.1,5.0,6.20,2.0\n9,1,20.2,5.0,6.21,2.0\n");
    EXPECT_THAT(read_recording(speeds).time, ElementsAre(0, 1));
}

/// Cells of a row of a Markdown table.
std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells;
    for (const Cell& cell : split_cells(line, '|', {}, InnerQuotes::kept).cells)
        cells.push_back(cell.text);
    return cells;
}

/// Rows of the table of names in docs/instruments.md: quantity, unit and names in five languages.
std::vector<std::vector<std::string>> names_in_manual() {
    std::vector<std::vector<std::string>> rows;
    bool within = false;
    for (const std::string& line : read_lines(PENDULAR_SOURCE_DIR "/docs/instruments.md")) {
        if (within && !line.starts_with('|')) break;
        if (within && !line.starts_with("|---")) rows.push_back(cells_of(line));
        within = within || line.starts_with("| quantity | unit, for example |");
    }
    return rows;
}

TEST(NamesInTheManual, AreReadWithUnitsInSixWays) {
    const TemporaryFolder folder;
    std::size_t cells = 0, headers = 0;
    /// Quantity of the first column, and its first number over that of the file, in SI units.
    const auto read_as = [&](const std::string& text) {
        ++headers;
        const Block block = read_blocks(folder.write("t.csv", text)).blocks.at(0);
        const std::string& quantity = block.columns.at(0).quantity;
        const std::string name = quantity == "rotational_speed" ? "angular_velocity" : quantity;
        const Columns columns(block.table);
        return std::pair(quantity,
                         columns.has(name) ? columns.value(block.table.rows.at(0), name) / 1.5 : 0);
    };
    const auto is = [](const std::string& quantity, const std::string& unit) {
        const double turns = quantity == "rotational_speed" ? 2 * std::numbers::pi : 1;
        const double expected = turns * Unit(unit).to_si(1);
        return testing::Pair(quantity, testing::DoubleNear(expected, 1e-12 * expected));
    };
    for (const auto& row : names_in_manual()) {
        ASSERT_EQ(row.size(), 9u);  // seven columns and what is outside of the table
        const std::string &quantity = row[1], &unit = row[2];
        for (std::size_t language = 3; language < 8; ++language, ++cells) {
            for (const Cell& name : split_cells(row[language], ',', {}, InnerQuotes::kept).cells) {
                for (const std::string& header :
                     {name.text + " [" + unit + "]", name.text + " (" + unit + ")",
                      name.text + " in " + unit, name.text + " / " + unit, name.text + ", " + unit})
                    EXPECT_THAT(read_as(header + ";Remark;Note\n1.5;2;4\n2.5;3;4\n"),
                                is(quantity, unit))
                        << header;
                for (const std::string& units : {unit + ";s;", "[" + unit + "];[s];"})
                    EXPECT_THAT(
                        read_as(name.text + ";Delay;Note\n" + units + "\n1.5;2;4\n2.5;3;4\n"),
                        is(quantity, unit))
                        << name.text << " above " << units;
            }
        }
    }
    EXPECT_GE(cells, 60u);
    EXPECT_GE(headers, 60u * 6);
}

TEST(NamedColumns, AreReadInPlaceOfOthers) {
    const TemporaryFolder folder;
    const auto path = folder.write(
        "t.csv",
        "Time [s],Torque [mN m],Moment am Deckel [uN m],Normal force [N],Gap [mm],Speed [rpm]\n"
        "0,20,7,5,6.2,2\n1,20,8,5,6.2,2\n");
    FileFormat format;
    format.named_columns = {{"torque", "Moment am Deckel [uN m]"}};
    EXPECT_NEAR(read_recording(path, format).torque[1], 8e-6, 1e-15);
    format.named_columns = {{"torque", "Moment am Deckel"}};
    EXPECT_NEAR(read_recording(path, format).torque[1], 8e-6, 1e-15);
    format.named_columns = {{"torque", "Md [uN m]"}};
    FileFormat two;
    two.columns = {"Time [s]", "Torque [N m]"};
    FileFormat vendor;
    vendor.columns = {"Time [s]"};
    const auto trios = std::string(PENDULAR_SOURCE_DIR "/tests/data/formats/trios.csv");
    const auto odd = folder.write(
        "o.csv",
        "Time [s],Mx [mN m],Normal force [N],Gap [mm],Speed [rpm]\n0,1,1,1,1\n1,1,1,1,1\n");
    expect_told({input_error([&] { read_recording(path, format); }),
                 input_error([&] { read_recording(path, two); }),
                 input_error([&] { read_recording(trios, vendor); }),
                 input_error([&] { read_recording(odd); })});
}

TEST(NamedColumns, TakeTheirErrorsAlong) {
    const TemporaryFolder folder;
    Study study;
    study.grains = {.diameter = 500e-6, .density = 2500};
    Source source;
    source.kind = Source::Kind::readings;
    source.format.named_columns = {{"shear_stress", "Wand [Pa]"}};
    const auto read = [&](const std::string& columns, const std::string& cells) {
        const Reading reading =
            read_points(folder.write("p.csv", "normal_stress [Pa],solid_fraction,inertial_number," +
                                                  columns + "\n1000,0.6,0," + cells + "\n"),
                        source, study)
                .readings.at(0);
        return std::pair(reading.value(0), std::sqrt(reading.covariance(0, 0)));
    };
    using testing::DoubleNear;
    using testing::Pair;
    const auto exactly = [](double value, double error) {
        return Pair(DoubleNear(value, 1e-9), DoubleNear(error, 1e-9));
    };
    EXPECT_THAT(read("shear_stress_se [Pa],Wand [Pa]", "7,400"), exactly(400, 7));
    EXPECT_THAT(read("Wand_sd [Pa],Wand [Pa]", "7,400"), exactly(400, 7));
    EXPECT_THAT(read("Wand [Pa],Wand_sd [Pa],Wand_n", "400,8,4"), exactly(400, 4));
    EXPECT_THAT(read("shear_stress [Pa],shear_stress_se [Pa],Wand [Pa],Wand_se [Pa]", "1,2,400,8"),
                exactly(400, 8));
    EXPECT_THAT(read("shear_stress [Pa],shear_stress_sd [Pa],shear_stress_n,Wand [Pa],Wand_se [Pa]",
                     "1,2,4,400,8"),
                exactly(400, 8));
    // Errors of the column that is replaced are not those of the other.
    EXPECT_THAT(read("shear_stress [Pa],shear_stress_se [Pa],Wand [Pa]", "1,2,400"),
                exactly(400, 0));
}

TEST(ColumnNames, OfAnAlternativeThatIsKnownAreSkipped) {
    const TemporaryFolder folder;
    Study study;
    study.grains = {.diameter = 500e-6, .density = 2500};
    Source source;
    source.kind = Source::Kind::readings;
    const Reading reading =
        read_points(folder.write(
                        "p.csv",
                        "normal_stress [Pa],shear_stress [Pa],"
                        "Spannungsverhältnis,solid_fraction,Schüttdichte [kg/m^3],inertial_number\n"
                        "1000,400,0.7,0.6,1200,0.01\n"),
                    source, study)
            .readings.at(0);
    EXPECT_DOUBLE_EQ(reading.value(0), 400);
    EXPECT_DOUBLE_EQ(reading.value(1), 0.6);
}

TEST(ColumnNames, OfIntervalsAreThoseOfWholeNumbers) {
    const TemporaryFolder folder;
    const auto intervals = [&](const std::string& name, const std::vector<std::string>& cells) {
        std::string text =
            "Time [s],Torque [mN m],Normal force [N],Gap [mm],Speed [rpm]," + name + "\n";
        for (std::size_t i = 0; i < cells.size(); ++i)
            text += fmt::format("{},20,5,6.2,2,{}\n", i, cells[i]);
        return read_recording(folder.write("t.csv", text)).interval;
    };
    EXPECT_THAT(intervals("Abschnitt", {"1", "1", "2"}), testing::ElementsAre(1, 1, 2));
    EXPECT_THAT(intervals("Schritt [1]", {"1", "1", "2"}), testing::ElementsAre(1, 1, 2));
    EXPECT_THAT(intervals("Abschnitt", {"Anlauf", "Anlauf", "Lauf"}), testing::IsEmpty());
    EXPECT_THAT(intervals("Abschnitt", {"0.5", "1", "1.5"}), testing::IsEmpty());
    EXPECT_THAT(intervals("Schritt [mm]", {"1", "1", "2"}), testing::IsEmpty());
}

TEST(NamedColumns, MayBeOfATableOfReadings) {
    const TemporaryFolder folder;
    folder.write("p.csv",
                 "Normalspannung [kPa];Tau am Deckel [Pa];Packungsdichte;Trägheitszahl\n"
                 "1,0;401,5;0,60;0,003\n2,0;803,5;0,60;0,003\n");
    const Study study = read_study(folder.write(
        "study.toml",
        "[grains]\ndiameter = \"500 um\"\ndensity = \"2500 kg/m^3\"\n[[readings]]\nfile = "
        "\"p.csv\"\ncolumns = { shear_stress = \"Tau am Deckel\" }\n"));
    const Measurements read = read_measurements(study);
    ASSERT_EQ(read.readings.size(), 2u);
    EXPECT_NEAR(read.readings[1].condition.normal_stress, 2000, 1e-9);
    EXPECT_NEAR(read.readings[1].value[0], 803.5, 1e-9);
    EXPECT_NEAR(read.readings[1].value[1], 0.6, 1e-12);
}

}  // namespace pendular::data_column_names_test
