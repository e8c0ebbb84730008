// Tables as people and home-built instruments write them: cells between blanks, tables side by
// side, units behind underscores, clock times of any country.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <map>
#include <numbers>

#include "data/files/column_names.h"
#include "data/files/formats/clock_times.h"
#include "data/files/formats/layouts.h"
#include "data/files/formats/text_shape.h"
#include "data/files/header_cell.h"
#include "data/files/workbook.h"
#include "data/quantities/units.h"
#include "data/recordings/file_view.h"
#include "data/recordings/recording.h"
#include "tests/support/golden.h"

namespace pendular::data_tables_of_people_test {

using testing::DoubleEq;
using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

TEST(HeaderCellOfAProgram, HasItsUnitBehindTheName) {
    EXPECT_EQ(parts("torque_mNm"), "torque|mNm");
    EXPECT_EQ(parts("normal_force_N"), "normal_force|N");
    EXPECT_EQ(parts("omega_rad_s"), "omega|rad/s");
    EXPECT_EQ(parts("speed_rad_per_s"), "speed|rad/s");
    EXPECT_EQ(parts("torque_N_m"), "torque|N m");
    EXPECT_EQ(parts("Gap mm"), "Gap|mm");
    EXPECT_EQ(parts("Gap {mm}"), "Gap|mm");
    EXPECT_EQ(parts("Gap <mm>"), "Gap|mm");
    EXPECT_EQ(parts("Gap: mm"), "Gap|mm");
    EXPECT_EQ(parts("Gap [mm]:"), "Gap|mm");
    EXPECT_EQ(parts("Gap（mm）"), "Gap|mm");
}

TEST(HeaderCellOfAProgram, KeepsWordsThatAreNoUnitOfTheQuantity) {
    for (const char* const name : {"shear_stress", "Time N", "gap_set", "Sample 3",
                                   "normal_force_n", "Run {seven}", "Shear stress w"})
        EXPECT_EQ(parts(name), std::string(name) + "|");
    EXPECT_EQ(parse_header_cell("shear_stress_sd").mark, ErrorMark::standard_deviation);
}

TEST(NamesWithoutAccents, AreThoseWithThem) {
    const auto meaning = [](const char* name, const char* unit) {
        return meaning_of_column(name, unit).quantity;
    };
    for (const char* const name : {"HÖHE", "Hoehe", "höhe", "Ho\u0308he"})
        EXPECT_EQ(meaning(name, "mm"), "height") << name;
    EXPECT_EQ(meaning("Velocita angolare", "giri/min"), "angular_velocity");
    EXPECT_EQ(meaning("Par de torsion", "mNm"), "torque");
    EXPECT_EQ(meaning("Vitesse_de_rotation", "tr/min"), "rotational_speed");
    EXPECT_EQ(meaning("γ", ""), "");  // a strain, not the rate "γ̇"
    EXPECT_EQ(meaning("γ̇", "1/s"), "shear_rate");
}

TEST(UnitsInOtherLanguages, AreWhatTheyMean) {
    const double turn = 2 * std::numbers::pi;
    EXPECT_THAT(Unit("Grad/s").to_si(1), DoubleNear(turn / 360, 1e-15));
    for (const char* const unit :
         {"tr/mn",     "r.p.m.", "Umdr./min", "vueltas/min", "obr/min", "obr./min",
          "obr./min.", "ot/min", "ot./min",   "otáčky/min",  "omw/min", "varv/min",
          "omdr./min", "o/min",  "rot/min",   "devir/dak",   "dev./dk", "ford/perc",
          "kierr/min", "об/мин", "об./мин."})
        EXPECT_THAT(Unit(unit).to_si(60), DoubleNear(turn, 1e-12)) << unit;
    for (const char* const degree : {"o/s", "o"})  // as some write "°"
        EXPECT_THROW(Unit{degree}, std::invalid_argument);
    EXPECT_THAT(Unit("kp").to_si(1), DoubleEq(9.80665));
    EXPECT_THAT(Unit("ozf").to_si(16), DoubleEq(4.4482216152605));
}

TEST(ClockTimeForms, AreReadInMoreForms) {
    const auto seconds = [](const char* text) {
        const auto time = clock_time(text);
        return time ? time->seconds : -1;
    };
    const double expected = seconds("2024-03-01 14:03:07.5");
    for (const char* const text :
         {"01.03.24 14:03:07,5", "01-Mar-2024 14:03:07.500", "2024-03-01T14:03:07.5Z",
          "2024-03-01T15:03:07.5+01:00", "2024-03-01 09:03:07:500-0500"})
        EXPECT_EQ(seconds(text), expected) << text;
    EXPECT_EQ(seconds("2:03.5"), 123.5);
    for (const char* const text : {"14:03", "31.02.24 14:03:07", "14:03:07:50"})
        EXPECT_EQ(seconds(text), -1) << text;
}

/// Files with text in a folder of their own.
class TableOfPeople : public testing::Test {
  protected:
    BlockFile read(const std::string& text, const std::string& name = "t.txt") {
        return read_blocks(folder_.write(name, text));
    }
    std::vector<double> column(const std::string& text, std::string_view quantity) {
        return series_of(read(text).blocks.at(0)).column(quantity);
    }
    std::string refusal(const std::string& text, const std::string& name = "t.txt") {
        return without_paths(input_error([&] { view_of_file(folder_.write(name, text)); }));
    }
    TemporaryFolder folder_;
};

TEST_F(TableOfPeople, MayHaveADecimalCommaBesideClockTimes) {
    EXPECT_THAT(column("Uhrzeit;Drehmoment [mNm];Normalkraft [N]\n14:03:07,5;15,25;12,4\n"
                       "14:03:08,0;15,34;12,4\n",
                       "time"),
                ElementsAre(0, 0.5));
    expect_told({refusal("Time;Torque [mN m];Normal force [N]\n14:03;1;2\n14:04;1;2\n")});
}

TEST_F(TableOfPeople, MayHaveItsCellsBetweenBlanks) {
    const std::string rows = "   0.0    15.25   12.4\n   0.5    15.34   12.4\n";
    for (const char* const names :
         {"Time [s]   Torque [mNm]   Normal force [N]\n",
          "Time [s] Torque [mNm] Normal force [N]\n", "# time_s torque_mNm normal_force_N\n",
          "# run 7\n% Time/s Torque/mNm Force/N\n", "# time [s], torque [mNm], force [N]\n",
          "\"Time [s]\" \"Torque [mNm]\" \"Force [N]\"\n",
          "Time   Torque   Normal force\n[s]    [mNm]   [N]\n", "Ring cell\n\nt_s M_mNm Fn_N\n"})
        EXPECT_THAT(column(names + rows, "torque"),
                    ElementsAre(DoubleEq(0.01525), DoubleEq(0.01534)))
            << names;
    EXPECT_EQ(read("Time [s]   Torque [mNm]\n  0  1\n  1  2\n").delimiter, ' ');
    EXPECT_THAT(column("  Time [s]  Torque [mNm]\n0  0  15.25\n1  0.5  15.5\n", "torque"),
                ElementsAre(DoubleEq(0.01525), DoubleEq(0.0155)));
    // The place of a number stays that of the file.
    expect_told({refusal("Time [s]   Torque [mNm]   Normal force [N]\n  0    1   2\n  1    2   3\n"
                         "  2    x   3\n"),
                 refusal("  0    1   2\n  1    2   3\n")});
}

TEST_F(TableOfPeople, MayHaveItsCellsBetweenBars) {
    EXPECT_THAT(
        column("| Time [s] | Torque [mNm] |\n|---|---:|\n| 0 | 15.25 |\n| 1 | 15.5 |\n", "torque"),
        ElementsAre(DoubleEq(0.01525), DoubleEq(0.0155)));
}

TEST_F(TableOfPeople, MayBreakLinesWithinTheNames) {
    const BlockFile file = read("\"Time\n[s]\",\"Torque\r\n[mNm]\"\n0,15.25\n1,15.5\n");
    EXPECT_EQ(file.blocks.at(0).columns.at(1).quantity, "torque");
    EXPECT_EQ(file.blocks.at(0).table.rows.at(0).line, 4);
    const auto path = folder_.write("r.csv",
                                    "\"Time\n[s]\",Torque [mNm],Force [N],Gap [mm],Speed [rpm]\n"
                                    "0,1,2,3,4\n1,1,2,3,4\n");
    EXPECT_EQ(read_recording(path).size(), 2u);
}

TEST_F(TableOfPeople, MayWriteNumbersAsFortranAndTypesettersDo) {
    EXPECT_THAT(column("Time [s],Torque [N m]\n0,1.5250D-02\n1,\u22121.5D-02\n", "torque"),
                ElementsAre(DoubleEq(0.01525), DoubleEq(-0.015)));
    EXPECT_THAT(column("Time [s]\tTorque [uNm]\n0\t15\u2019250.5\n1\t15\u2019500.5\n", "torque"),
                ElementsAre(DoubleEq(0.0152505), DoubleEq(0.0155005)));
    std::string names = "Sample 3D-2,s\u22121\n1,2\n";
    shape_text(names);
    EXPECT_EQ(names, "Sample 3D-2,s\u22121\n1,2\n");
}

TEST_F(TableOfPeople, MayEndItsRowsWithADelimiter) {
    EXPECT_THAT(column("Time [s];Torque [mNm]\n0;15.25;\n1;15.5;\n", "torque"), SizeIs(2));
    EXPECT_THAT(refusal("Time [s];Torque [mNm]\n0;15.25;3\n1;15.5;\n"), HasSubstr("t.txt:2:"));
}

TEST_F(TableOfPeople, MayBeOfAnOldMacintosh) {
    EXPECT_THAT(column("Temps [s];Couple [\xb5N\xe1m]\r0;15250\r1;15500\r", "torque"),
                ElementsAre(DoubleEq(0.01525), DoubleEq(0.0155)));
}

TEST_F(TableOfPeople, MayStandBesideOthers) {
    const std::string text =
        "2 kPa;;;;4 kPa;;\nTime [s];Torque [mNm];F [N];;Time [s];Torque [mNm];F [N]\n"
        "0;15.25;12;;0;30.5;24\n1;15.5;12;;1;31;24\n;;;;2;31.5;24\n";
    const BlockFile file = read(text);
    ASSERT_THAT(file.blocks, SizeIs(2));
    EXPECT_EQ(file.blocks[0].test, "2 kPa");
    EXPECT_EQ(file.blocks[1].test, "4 kPa");
    EXPECT_THAT(series_of(file.blocks[0]).torque, ElementsAre(DoubleEq(0.01525), DoubleEq(0.0155)));
    EXPECT_THAT(series_of(file.blocks[1]).torque,
                ElementsAre(DoubleEq(0.0305), DoubleEq(0.031), DoubleEq(0.0315)));
    EXPECT_THAT(refusal(text + "0;15.25;12;;3;x;24\n"), HasSubstr("t.txt:6:15: "));
}

TEST_F(TableOfPeople, MayStandBelowAnother) {
    const std::string names = "Time [s],Torque [mNm],Normal force [N],Gap [mm],Speed [rpm]\n";
    const std::string rows = "0,15.25,12,6.2,2\n1,15.5,12,6.2,2\n";
    const auto path =
        folder_.write("t.csv", "First\n" + names + rows + "\nSecond\n" + names + rows);
    const BlockFile file = read_blocks(path);
    ASSERT_THAT(file.blocks, SizeIs(2));
    EXPECT_EQ(file.blocks[0].test, "First");
    EXPECT_EQ(file.blocks[1].test, "Second");
    EXPECT_EQ(file.blocks[1].table.rows.at(1).line, 9);
    EXPECT_THAT(read_recording(path).interval, ElementsAre(1, 1, 2, 2));
}

TEST_F(TableOfPeople, MayNameItsIntervals) {
    std::string text = "Segment,Time [s],Torque [mNm],Normal force [N],Gap [mm],Speed [rpm]\n";
    for (int i = 0; i < 8; ++i)
        text += fmt::format("{},{},15.25,12,6.2,2\n", i < 4 ? "Preshear" : "Shear", i);
    const auto path = folder_.write("t.csv", text);
    const FileView view = view_of_file(path);
    ASSERT_THAT(view.file.blocks, SizeIs(2));
    EXPECT_EQ(view.file.blocks[1].name, "Shear");
    FileFormat format;
    format.roles = {{"preshear", {"Preshear"}}};
    EXPECT_THAT(read_recording(path, format).interval, ElementsAre(2, 2, 2, 2));
}

TEST_F(TableOfPeople, OfSeveralPreshearsMakesALocusEach) {
    std::string text = "3 kPa;;;6 kPa;\nsigma [Pa];tau [Pa];;sigma [Pa];tau [Pa]\n";
    for (const int k : {1, 2, 3, 4})
        text += fmt::format("{};{};;{};{}\n", 500 * k, 100 + 250 * k, 1000 * k, 200 + 500 * k);
    const FileView view = view_of_file(folder_.write("t.csv", text));
    ASSERT_THAT(view.loci, SizeIs(2));
    EXPECT_THAT(view.loci[0].line.value().cohesion, DoubleNear(100, 1e-9));
    EXPECT_THAT(view.loci[1].line.value().cohesion, DoubleNear(200, 1e-9));
}

TEST_F(TableOfPeople, OfARingShearTesterHasItsNames) {
    for (const char* const names :
         {"sigma pre [Pa];tau pre [Pa];sigma sh [Pa];tau sh [Pa];rho b [kg/m^3]",
          "σpre [Pa];τpre [Pa];σsh [Pa];τsh [Pa];ρb [kg/m³]",
          "Sigma_an [Pa];Tau_an [Pa];Sigma_ab [Pa];Tau_ab [Pa];Schuettdichte [kg/m³]",
          "Pre-shear normal stress [Pa];Pre-shear shear stress [Pa];Normal stress at failure [Pa];"
          "Peak shear stress [Pa];Bulk density [kg/m^3]"}) {
        std::string text = std::string(names) + "\n";
        for (const int k : {1, 2, 3, 4})
            text += fmt::format("3000;1520;{};{};780\n", 500 * k, 100 + 250 * k);
        const FileView view = view_of_file(folder_.write("t.csv", text));
        ASSERT_THAT(view.loci, SizeIs(1)) << names;
        EXPECT_TRUE(view.loci[0].preshear) << names;
        EXPECT_EQ(view.file.blocks[0].bulk_density, 780) << names;
    }
}

TEST_F(TableOfPeople, SaysInItsTitleThatItIsOfAWall) {
    std::string text = "Wall friction test, stainless steel\n\nsigma [Pa],tau [Pa]\n";
    for (const int k : {1, 2, 3, 4})
        text += fmt::format("{},{}\n", 500 * k, 200 * k);
    EXPECT_THAT(view_of_file(folder_.write("t.csv", text)).walls, SizeIs(1));
}

/// The units alone show which column is which, unless several or other quantities have them.
TEST_F(TableOfPeople, IsReadByItsUnitsWhereTheyFitOneColumn) {
    const auto by_unit = [&](const std::string& names) {
        return view_of_file(folder_.write("t.csv", names + "\n0,15,12,6.2,2\n1,15,12,6.2,2\n"))
            .by_unit;
    };
    using Columns = std::map<std::string, std::string>;
    EXPECT_EQ(by_unit("Time [s],Moment am Deckel [mNm],Load cell [N],Bed [mm],Motor [rpm]"),
              (Columns{{"torque", "Moment am Deckel [mNm]"},
                       {"normal_force", "Load cell [N]"},
                       {"height", "Bed [mm]"},
                       {"rotational_speed", "Motor [rpm]"}}));
    EXPECT_EQ(by_unit("Time [s],Torque [mNm],Left [N],Right [N],Lid displacement [mm]"), Columns());
    EXPECT_EQ(by_unit("Time [s],Torque [mNm],Load set [N],Gap [mm],Filter [Hz]"), Columns());
    EXPECT_EQ(by_unit("Time [s],Work [J],Normal force [N],Gap [mm],Delta [1/s]"), Columns());
    EXPECT_EQ(by_unit("Time [s],A [kPa],B [mK],Gap [mm],Speed [rpm]"), Columns());
    const auto path = folder_.write(
        "t.csv", "Time [s],Twist [uNm],Normal force [N],Gap [mm],Speed [rpm]\n0,15,12,6.2,2\n");
    EXPECT_THAT(view_of_file(path).series.at(0).torque, ElementsAre(DoubleEq(15e-6)));
    // A study reads it only where it says so.
    expect_told({input_error([&] { read_recording(path); })});
}

/// Columns that no mapping names are read as without any.
TEST_F(TableOfPeople, IsReadByItsUnitsBesideColumnsThatAreNamed) {
    const auto path = folder_.write(
        "t.csv",
        "Time [s],Moment am Deckel [mNm],Load cell [N],Bed [mm],Motor [Ticks]\n0,15,12,6.2,2\n");
    FileFormat format;
    format.named_columns["rotational_speed"] = "Motor [rpm]";
    const FileView view = view_of_file(path, format);
    EXPECT_THAT(view.missing, testing::IsEmpty());
    EXPECT_EQ(view.by_unit.size(), 3u);
}

/// A column in a unit that is none may be what is missing.
TEST_F(TableOfPeople, NamesColumnsInUnknownUnits) {
    const std::string rows = "0,15,12,6.2,2,a\n1,15,12,6.2,2,b\n";
    const auto view = [&](const std::string& names) {
        return view_of_file(folder_.write("t.csv", names + "\n" + rows));
    };
    const FileView speed =
        view("Time [s],Torque [mNm],Normal force [N],Gap [mm],Motor [Qx/min],Note [Qy]");
    ASSERT_EQ(speed.candidates.size(), 1u);
    EXPECT_EQ(speed.candidates[0].quantity, "rotational_speed");
    EXPECT_EQ(speed.roles.at(0).reason, "sheared; the speed of the lid is not known");
    const FileView force = view("Time [s],Torque [mNm],Load [Qz],Gap [mm],Speed [rpm],Note [Qy]");
    ASSERT_EQ(force.candidates.size(), 1u);
    EXPECT_EQ(force.candidates[0].quantity, "normal_force");
    // A force that no other one stands beside is no lever's.
    const FileView named = view("Time [s],Angle [deg],Kraft1 [N],Gap [mm],Speed [rpm],Kraft2 [N]");
    ASSERT_FALSE(named.candidates.empty());
    EXPECT_EQ(named.candidates[0].quantity, "normal_force");
}

/// Whole numbers that change with the speed may number the intervals, whatever their name.
TEST_F(TableOfPeople, MayNumberIntervalsInAColumnOfAnyName) {
    std::string text =
        "Time [s],Torque [mNm],Normal force [N],Gap [mm],Speed [rpm],Xyz,Code,Half\n";
    for (int i = 0; i < 120; ++i)
        text += fmt::format("{},14.{},12,6.2,{},{},{},{}\n", i, i * i % 7, i < 60 ? 60 : 180,
                            i < 61 ? 4 : 7, i < 30 ? 1 : 2, i < 60 ? 0.5 : 1);
    const FileView view = view_of_file(folder_.write("t.csv", text));
    ASSERT_THAT(view.candidates, SizeIs(1));
    EXPECT_EQ(view.candidates[0].name, "Xyz");
    EXPECT_EQ(view.candidates[0].quantity, "interval");
    expect_told({view.roles.at(0).reason});
}

/// A factor of 1000 between the unit that is stated and that of the file is not passed over.
TEST_F(TableOfPeople, IsRefusedInAnotherUnitThanItStates) {
    const auto path = folder_.write(
        "t.csv", "Time [s],Md [N·m],Normal force [N],Gap [mm],Speed [rpm]\n0,0.02,12,6.2,2\n");
    FileFormat format;
    format.named_columns["torque"] = "Md [mN m]";
    expect_told({input_error([&] { read_recording(path, format); })});
    for (const char* const same : {"Md [N m]", "Md [N·m]", "Md"}) {
        format.named_columns["torque"] = same;
        EXPECT_THAT(read_recording(path, format).torque, ElementsAre(0.02));
    }
}

TEST_F(TableOfPeople, IsReadInFurtherLanguages) {
    for (const char* const header :
         {"Czas [s]\tMoment obrotowy [mN·m]\tSiła normalna [N]\tSzczelina [mm]\tPrędkość "
          "obrotowa [obr/min]\tOdcinek [-]",
          "Czas [s]\tMoment obrotowy [mN·m]\tSila normalna [N]\tSzczelina [mm]\tPredkosc "
          "obrotowa [obr/min]\tKrok",
          "Čas [s]\tKroutící moment [mNm]\tNormálová síla [N]\tŠtěrbina [mm]\tOtáčky "
          "[ot./min]\tÚsek",
          "Tijd [s]\tKoppel [mNm]\tNormaalkracht [N]\tSpleet [mm]\tToerental [omw/min]\tStap",
          "Tid [s]\tVridmoment [mNm]\tNormalkraft [N]\tSpalthöjd [mm]\tVarvtal [varv/min]\tSteg",
          "Tid [s]\tDrejningsmoment [mNm]\tAksialkraft [N]\tSpaltehøjde [mm]\tOmdrejningstal "
          "[omdr./min]\tTrin",
          "Tempo [s]\tBinário [mNm]\tForça normal [N]\tFolga [mm]\tVelocidade de rotação "
          "[rpm]\tEtapa",
          "Zaman [s]\tTork [mNm]\tNormal kuvvet [N]\tBoşluk [mm]\tDönme hızı [devir/dak]\tAdım",
          "Idő [s]\tNyomaték [mNm]\tNormálerő [N]\tRésméret [mm]\tFordulatszám [ford/perc]\t"
          "Szakasz",
          "Aika [s]\tVääntömomentti [mNm]\tNormaalivoima [N]\tRako [mm]\tPyörimisnopeus "
          "[kierr/min]\tJakso"}) {
        const FileView view = view_of_file(folder_.write(
            "t.txt", std::string(header) + "\n0\t20\t5\t6.2\t30\t1\n1\t20\t5\t6.2\t60\t2\n"));
        EXPECT_THAT(view.missing, testing::IsEmpty()) << header;
        EXPECT_THAT(view.by_unit, testing::IsEmpty()) << header;
        ASSERT_EQ(view.series.size(), 2u) << header;
        EXPECT_THAT(view.series[1].angular_velocity,
                    ElementsAre(DoubleNear(2 * std::numbers::pi, 1e-12)))
            << header;
    }
}

TEST_F(TableOfPeople, OfStressRatiosHasShearStresses) {
    EXPECT_THAT(column("Normal stress [Pa],Stress ratio\n1000,0.5\n2000,0.4\n", "shear_stress"),
                ElementsAre(500, 800));
}

TEST_F(TableOfPeople, MayBeAnExportOfLabView) {
    const std::string header =
        "LabVIEW Measurement\t\nSeparator\tTab\n***End_of_Header***\t\n\nChannels\t2\t\n"
        "Date\t2024/03/01\t2024/03/01\nX0\t0\t0\nDelta_X\t0.5\t0.5\n***End_of_Header***\t\t\n";
    EXPECT_THAT(column(header + "X_Value [s]\tTorque [mNm]\n0\t15.25\n0.5\t15.5\n", "torque"),
                ElementsAre(DoubleEq(0.01525), DoubleEq(0.0155)));
}

TEST_F(TableOfPeople, IsToldWhatItLacks) {
    const std::string rows = "0,15.25,12\n1,15.5,12\n";
    FileFormat two;
    expect_told({refusal("Time,Torque,Normal force\n" + rows),
                 refusal("Time [s],Torque,Normal force [N]\n" + rows),
                 refusal("Time [s],Torque [mNm]\n1,0,15.25\n2,1,15.5\n"),
                 refusal("%PDF-1.4\n1 0 obj\n"), refusal("\x1f\x8b\x08 and so on")});
}

TEST_F(TableOfPeople, IsNoneThatTheProgramWroteOfItsResults) {
    const std::string atlas = content_of(PENDULAR_SOURCE_DIR "/sim/atlas/atlas.csv");
    expect_told({refusal(atlas.substr(0, atlas.find('\n', atlas.find('\n') + 1) + 1)),
                 refusal("quantity,value,standard error,unit,remark\nfriction,0.2,0.01,1,\n"),
                 refusal("friction,inertial_number,reduced_pressure,bridge_volume,stress_ratio\n"
                         "0.09,0.001,,,0.25\n")});
}

TEST_F(TableOfPeople, MayMarkMissingValuesInGerman) {
    const std::vector<double> torque =
        column("Zeit [s];Drehmoment [mNm]\n0;k.A.\n1;n.b.\n2;-\n3;1.#QNAN\n4;15,5\n", "torque");
    ASSERT_THAT(torque, SizeIs(5));
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_TRUE(std::isnan(torque[i])) << i;
    EXPECT_THAT(torque[4], DoubleEq(0.0155));
}

}  // namespace pendular::data_tables_of_people_test
