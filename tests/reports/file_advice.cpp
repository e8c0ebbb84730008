// What `import FILE` advises where a file lacks something: lines that can be followed, and only
// what is true of the file at hand.
#include "reports/file_advice.h"

#include <fmt/format.h>

#include "data/recordings/file_view.h"
#include "tests/support/golden.h"
#include "workflow/file_views.h"

namespace pendular::reports_file_advice_test {

class FileAdvice : public testing::Test {
  protected:
    std::string advice(const std::string& text, const std::string& name = "t.csv") {
        try {
            return missing_sentence(view_of_file(folder_.write(name, text)));
        } catch (const InputError& error) {
            return error.what();
        }
    }
    TemporaryFolder folder_;
};

TEST_F(FileAdvice, OnTablesOfTestsOrOfMeans) {
    expect_told(
        {advice("Time [min];Normal stress [kPa];Shear stress [kPa]\n3;1.0;0.31\n8;2.0;0.62\n"
                "13;4.0;1.24\n18;8.0;2.48\n"),
         advice("Speed [rpm],Normal stress [kPa],Shear stress [kPa],Gap [mm]\n2,1,0.31,6.16\n"
                "2,2,0.62,6.15\n2,4,1.24,6.14\n20,1,0.33,6.2\n20,2,0.65,6.19\n"),
         advice("Time [s],Torque [mN m]\n0,1\n1,1\n2,1\n")});
}

TEST_F(FileAdvice, OnResultsOfYieldLoci) {
    expect_told(
        {advice("σ1 [Pa],σc [Pa],ffc [-],ρb [kg/m³]\n1980,412,4.81,1421\n4050,633,6.4,1455\n"),
         advice("Principal consolidating stress (kPa);Unconfined failure strength (kPa);Bulk "
                "density (kg/m³)\n0.61;0.21;812\n1.22;0.38;845\n2.43;0.61;880\n")});
}

TEST_F(FileAdvice, OnColumnsThatMayBeSeveralThings) {
    expect_told(
        {advice("Time [s],Alpha [kPa],Beta [kPa],Gap [mm],Speed [rpm]\n0,1,2,6,2\n1,1,2,6,2\n"),
         advice("Time [s],Alpha [Qx],Beta [Qy],Gap [mm],Speed [rpm]\n0,1,2,6,2\n1,1,2,6,2\n")});
}

TEST_F(FileAdvice, OnPeaksBesideResidualStresses) {
    const auto of = [&](const std::string& names) {
        return advice(names + "\n2000;1250;1000\n4000;2330;1864\n6000;3400;2800\n");
    };
    expect_told({of("Normal stress [Pa];Shear stress max [Pa];Shear stress min [Pa]"),
                 of("Normal stress [Pa];Contrainte maximale [Pa];Contrainte résiduelle [Pa]"),
                 of("Tensión normal [Pa];Valor máx. [Pa];Succión [Pa]")});
}

TEST_F(FileAdvice, OnColumnsOfCorrectedValues) {
    const std::string rows = "2000;1250;1000\n4000;2330;1864\n6000;3400;2800\n";
    const auto corrected = [&](const std::string& names) {
        return corrected_sentences(view_of_file(folder_.write("t.csv", names + "\n" + rows)));
    };
    expect_told(corrected("Normal stress [Pa];Shear stress [Pa];Shear stress (corrected) [Pa]"));
    EXPECT_TRUE(corrected("Normal stress [Pa];Shear stress [Pa];Shear stress 2 [Pa]").empty());
}

TEST_F(FileAdvice, OnMassesForForces) {
    const auto torque = [&](const std::string& header) {
        return advice("Time [s],\"" + header +
                      "\",Normal force [N],Gap [mm],Speed [rpm]\n0,1,2,6,2\n1,1,2,6,2\n");
    };
    expect_told({torque("Torque [in-lb]"), torque("Torque [lb-in]"), torque("Torque [ft-lb]"),
                 torque("Torque [oz-in]"), torque("Torque [in-lbs]"), torque("Torque [inlb]"),
                 torque("Torque [IN-LB]"), torque("Torque, in-lbs"),
                 advice("Normal stress [lb/ft²],Shear stress [lb/in2]\n1,2\n2,3\n3,4\n")});
}

TEST_F(FileAdvice, OnTablesThatLie) {
    expect_told({advice("Time;s;0;1;2;3\nTorque;mN m;17;18;19;20\nGap;mm;6;6;6;6\n"),
                 advice("Time [s];0;1;2;3\nTorque [mN m];17;18;19;20\n")});
}

TEST_F(FileAdvice, OnCellsThatHoldMoreThanANumber) {
    const auto cell = [&](const std::string& text) {
        return advice(
            "Time [s],Torque [mN m],Normal force [N],Gap [mm],Speed [rpm]\n0,50.1,2,6,2\n1," +
            text + ",2,6,2\n");
    };
    expect_told({cell("50.1 ± 0.4"), cell("50.1 mN m"), cell("50.1x")});
}

TEST_F(FileAdvice, OnSpreadsheetsInXml) {
    expect_told(
        {advice("<?xml version=\"1.0\"?>\n<Workbook "
                "xmlns=\"urn:schemas-microsoft-com:office:spreadsheet\"></Workbook>\n",
                "t.xls")});
}

/// A sheet of a workbook is named by a key of its own.
TEST_F(FileAdvice, OnASheetOfReadingsCanBePasted) {
    const auto rows = folder_.write("rows.csv",
                                    "Normal stress [kPa],Shear stress [kPa],Solid fraction "
                                    "[%],Inertial number [1]\n1,0.31,60,0.001\n2,0.62,60,0.001\n");
    const auto book = folder_.path() / "book.xlsx";
    const std::string command = "python3 " PENDULAR_SOURCE_DIR "/tests/data/make_workbook.py " +
                                book.string() + " P=" + rows.string();
    ASSERT_EQ(std::system(command.c_str()), 0);
    expect_told({missing_sentence(view_of_file(book)),
                 input_error([&] { refuse_to_begin(view_of_file(book)); })});
}

}  // namespace pendular::reports_file_advice_test
