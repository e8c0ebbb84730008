// Columns that are not what their unit, or their name alone, could make them: angles called φ,
// pressures of the air, ways of the lid, clock times, results and moduli.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "data/files/column_names.h"
#include "data/quantities/units.h"
#include "data/recordings/columns_by_unit.h"
#include "data/recordings/file_view.h"
#include "tests/support/golden.h"

namespace pendular::data_other_columns_test {

using testing::AllOf;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;
using testing::StartsWith;

class OtherColumns : public testing::Test {
  protected:
    FileView view(const std::string& text) { return view_of_file(folder_.write("t.csv", text)); }

    /// A recording of steady shear with one more column.
    FileView with_column(const std::string& header) {
        std::string text = "Time [s],Torque [mN m],Normal force [N],Gap [mm],Speed [rpm]," + header;
        for (int i = 0; i < 40; ++i)
            text += fmt::format("\n{},20,5,6.2,2,{}", i, 1 + i);
        return view(text + "\n");
    }

    /// A recording in which one column has another name and unit.
    FileView with_one_named(std::size_t index, const std::string& header) {
        std::vector<std::string> names = {"Time [s]", "Torque [mN m]", "Normal force [N]",
                                          "Gap [mm]", "Speed [rpm]"};
        names[index] = header;
        std::string text = fmt::format("{}", fmt::join(names, ","));
        for (int i = 0; i < 40; ++i)
            text += fmt::format("\n{},20,5,6.2,2", i);
        return view(text + "\n");
    }

    TemporaryFolder folder_;
};

TEST_F(OtherColumns, SymbolInTheUnitOfSomethingElseIsNoQuantity) {
    const std::string points =
        "Normal stress [Pa],Shear stress [Pa],{}\n500,352,33.1\n"
        "1000,611,33.4\n2000,1125,33.3\n4000,2148,33.0\n";
    for (const char* const header : {"φ [°]", "phi [deg]", "φ (rad)", "T [°C]", "M [g]", "n [N]"})
        EXPECT_TRUE(view(fmt::format(fmt::runtime(points), header)).file.table_of_points) << header;
    EXPECT_FALSE(view(fmt::format(fmt::runtime(points), "φ [%]")).file.table_of_points);
    EXPECT_EQ(quantity_of_cell("φ", "1")->name, "solid_fraction");
    EXPECT_EQ(quantity_of_cell("φ", "")->name, "solid_fraction");
    EXPECT_EQ(quantity_of_cell("T", "mN m")->name, "torque");
    EXPECT_EQ(quantity_of_cell("Speed", "kg")->name, "rotational_speed");  // refused by its reader
}

TEST_F(OtherColumns, OfOtherTestsAreKnownInMoreLanguages) {
    for (const char* const header :
         {"Komplexe Viskosität [Pa·s]", "tan δ [-]", "Angolo di fase [°]", "Strain amplitude [%]",
          "MÓDULO DE PÉRDIDA [Pa]", "Moduł zachowawczy [Pa]", "Opslagmodulus [Pa]",
          "Lagringsmodul [Pa]", "貯蔵弾性率 [Pa]", "储能模量 [Pa]", "J(t) [1/Pa]", "G(t) [Pa]",
          "Recoverable compliance [1/Pa]", "Ztrátový modul [Pa]", "Viscosité complexe [Pa s]"})
        EXPECT_EQ(with_column(header).roles.at(0).role, "other") << header;
    for (const char* const header : {"Amplitude of the motor [mA]", "Compactness [1]", "J [A]",
                                     "Frequenz [Hz]", "Vinkelfrekvens [rad/s]"})
        EXPECT_EQ(with_column(header).roles.at(0).role, "steady") << header;
    for (const char* const header :
         {"Pulsazione [rad/s]", "Hoekfrequentie [rad/s]", "Vinkelfrekvens [rad/s]",
          "角周波数 [rad/s]", "Frequência angular [rad/s]", "Kulmataajuus [rad/s]"}) {
        const FileView turned = with_one_named(4, header);
        EXPECT_THAT(turned.by_unit, IsEmpty()) << header;
        EXPECT_EQ(turned.roles.at(0).role, "other") << header;
    }
}

TEST_F(OtherColumns, TitleTellsWallFrictionInMoreLanguages) {
    const auto is_wall = [&](const std::string& title) {
        std::string text = title + "\nNormal stress [kPa];Shear stress [kPa]\n";
        for (const int k : {1, 2, 4, 8})
            text += fmt::format("{};{}\n", k, 0.31 * k);
        return !view(text).walls.empty();
    };
    for (const char* const title :
         {"Wall friction", "Friction at the wall", "Wandreibung", "Reibung an der Wand",
          "Frottement à la paroi", "Frottement contre la paroi", "Fricción con la pared",
          "Rozamiento con la pared", "Attrito con la parete", "Angolo d'attrito alla parete",
          "Tarcie o ścianę", "Kąt tarcia o ścianę", "Wandwrijving", "Väggfriktion",
          "Atrito com a parede", "Fricção na parede", "Tření o stěnu", "壁面摩擦"})
        EXPECT_TRUE(is_wall(title)) << title;
    for (const char* const title :
         {"Internal friction, wall of steel", "Friction of prepared sand", "Rough walls, friction",
          "Kąt tarcia wewnętrznego", "Attrito interno", "Verwandte Reibung"})
        EXPECT_FALSE(is_wall(title)) << title;
}

TEST_F(OtherColumns, AreNotReadByTheirUnit) {
    for (const char* const header :
         {"Tangential force [N]", "Friction force [N]", "Fx [N]", "Radial force Fx [N]",
          "Zugkraft [N]", "Lid weight [N]", "Ambient pressure [mbar]", "Luftdruck [hPa]",
          "Pore pressure [Pa]", "Suction [kPa]", "Air pressure [kPa]", "Δ force [N]"})
        EXPECT_THAT(with_one_named(2, header).by_unit, IsEmpty()) << header;
    for (const char* const header :
         {"Outer diameter [mm]", "Bead diameter [mm]", "Dilation [mm]", "Dilatanz [mm]", "Δh [mm]",
          "Gap change [mm]", "Lever arm [mm]", "Setzung [mm]", "Thread pitch [mm]", "Radius [mm]",
          "Höhenänderung [mm]", "Amplitude [µm]", "Kapillarlänge [mm]"})
        EXPECT_THAT(with_one_named(3, header).by_unit, IsEmpty()) << header;
    EXPECT_THAT(with_one_named(1, "Bearing friction [mN m]").by_unit, IsEmpty());
    EXPECT_THAT(with_one_named(1, "Yield stress [Pa]").by_unit, IsEmpty());
    EXPECT_THAT(with_one_named(1, "Torque increment [mN m]").by_unit, IsEmpty());
    EXPECT_THAT(with_one_named(4, "Lüfterdrehzahl [1/min]").by_unit, IsEmpty());
    EXPECT_THAT(with_one_named(0, "Relaxation time [s]").by_unit, IsEmpty());
    // A gear divides the speed of the motor.
    std::string geared =
        "Gear ratio: 100:1\nTime [s];Torque [mN m];Normal force [N];Gap [mm];Motor [rpm]";
    for (int i = 0; i < 40; ++i)
        geared += fmt::format("\n{};20;5;6.2;200", i);
    EXPECT_THAT(view(geared + "\n").by_unit, IsEmpty());
    // Names that say nothing are read, since no other column fits.
    for (const auto& [index, header] : {std::pair{1, "Mz [mN m]"},
                                        {2, "Fz [N]"},
                                        {2, "Load cell [N]"},
                                        {2, "Paired cell [N]"},
                                        {3, "z [mm]"},
                                        {3, "Bed [mm]"},
                                        {3, "Charmed bed [mm]"},
                                        {4, "Motor [rpm]"},
                                        {0, "Total [s]"}})
        EXPECT_THAT(with_one_named(static_cast<std::size_t>(index), header).by_unit, SizeIs(1))
            << header;
}

/// A time that stays the same is none.
TEST_F(OtherColumns, ConstantsAreNoTimes) {
    std::string text = "Pulse [s],Torque [mN m],Normal force [N],Gap [mm],Speed [rpm]\n";
    for (int i = 0; i < 40; ++i)
        text += "0.5,20,5,6.2,2\n";
    EXPECT_THAT(view(text).by_unit, IsEmpty());
}

TEST_F(OtherColumns, OfClockTimesAreTimesWhateverTheirName) {
    for (const char* const header : {"Datum", "Date", "Zeitpunkt", "DateTime (UTC)", "Clock",
                                     "日時", "Datum/Zeit", "Date and time"}) {
        std::string text =
            std::string(header) + ",Torque [mN m],Normal force [N],Gap [mm],Speed [rpm]\n";
        for (int i = 0; i < 40; ++i)
            text += fmt::format("2023-11-05 14:03:{:02},20,5,6.2,2\n", i);
        const FileView recorded = view(text);
        EXPECT_THAT(recorded.missing, IsEmpty()) << header;
        ASSERT_THAT(recorded.series.at(0).time, SizeIs(40)) << header;
        EXPECT_EQ(recorded.series.at(0).time.back(), 39) << header;
    }
    // The day of a test makes no recording of a table of points.
    for (const char* const header : {"Datum", "Date and time", "Datum/Zeit", "Clock"}) {
        std::string points = std::string(header) + ",Normal stress [Pa],Shear stress [Pa]\n";
        for (const int k : {1, 2, 3, 4})
            points += fmt::format("2023-11-05 14:0{}:00,{},{}\n", k, 500 * k, 100 + 250 * k);
        EXPECT_THAT(view(points).loci, SizeIs(1)) << header;
    }
}

TEST_F(OtherColumns, AreReadInJapaneseAndChinese) {
    for (const char* const header :
         {"時間（秒）,トルク（mN･m）,法線力（N）,ギャップ（mm）,回転速度（min-1）",
          "時間 [s],トルク [mN・m],垂直荷重 [N],試料高さ [mm],回転数 [回転/分]",
          "时间 [秒],扭矩 [mN·m],法向力 [N],间隙 [㎜],转速 [1/min]",
          "時間 [s],せん断応力 [kPa],垂直応力 [kPa],試料高さ [mm],回転数 [min⁻¹]"}) {
        const FileView read = view(std::string(header) + "\n0,20,5,6.2,2\n1,20,5,6.2,2\n");
        EXPECT_THAT(read.missing, IsEmpty()) << header;
        EXPECT_THAT(read.by_unit, IsEmpty()) << header;
    }
}

TEST_F(OtherColumns, OfSetPointsAreKnownByGermanWordsToo) {
    for (const char* const name : {"Solldrehzahl", "Soll-Drehzahl", "Drehzahl-Soll",
                                   "Drehzahlsollwert", "Drehzahl (soll)", "Vorgabe Drehzahl"})
        EXPECT_EQ(set_point_of(name, "1/min"), "rotational_speed") << name;
    EXPECT_EQ(set_point_of("Soll-Normalkraft", "N"), "normal_force");
    EXPECT_EQ(set_point_of("Solltemperatur", "degC"), "");
}

/// Two stresses, of which both are missing, may be each.
TEST_F(OtherColumns, MayBeOneOfSeveralQuantities) {
    const FileView two = view(
        "Time [s],Alpha [kPa],Beta [kPa],Gap [mm],Speed [rpm]\n0,1,2,6,2\n"
        "1,1,2,6,2\n");
    ASSERT_THAT(two.candidates, SizeIs(2));
    for (const BlockColumn& column : two.candidates)
        EXPECT_THAT(possible_quantities(column, two), ElementsAre("shear_stress", "normal_stress"));
    const FileView unknown = view(
        "Time [s],Alpha [Qx],Beta [Qy],Gap [mm],Speed [rpm]\n0,1,2,6,2\n"
        "1,1,2,6,2\n");
    ASSERT_THAT(unknown.candidates, SizeIs(2));
    EXPECT_THAT(possible_quantities(unknown.candidates[0], unknown), SizeIs(2));
    // Results of yield loci are no stresses of points.
    EXPECT_THAT(view("σ1 [Pa],σc [Pa],ffc [-],ρb [kg/m³]\n1980,412,4.81,1421\n4050,633,6.4,1455\n")
                    .candidates,
                IsEmpty());
}

}  // namespace pendular::data_other_columns_test
