// Tables of points at common loads, with the shear stress of each material, liquid or preshear in a
// column of its own.
#include <fmt/format.h>

#include "data/files/columns.h"
#include "data/recordings/file_view.h"
#include "tests/support/golden.h"

namespace pendular::data_stresses_beside_test {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

FileView points(const std::string& text) {
    const TemporaryFolder folder;
    return view_of_file(folder.write("points.csv", text));
}

/// Rows of a load and of stresses on 0.2 kPa + 0.51 s, each further one with 0.18 kPa more.
std::string rows(int stresses, const std::string& behind_each = "") {
    std::string text;
    for (const double load : {1.0, 2.0, 3.0, 4.0}) {
        text += fmt::format("{}", load);
        for (int k = 0; k < stresses; ++k)
            text += fmt::format(";{:.2f}{}", 0.2 + 0.18 * k + 0.51 * load, behind_each);
        text += "\n";
    }
    return text;
}

std::vector<std::string> groups(const FileView& view) {
    std::vector<std::string> names;
    for (const Block& block : view.file.blocks)
        if (names.empty() || names.back() != block.test) names.push_back(block.test);
    return names;
}

void expect_two(const FileView& view, const std::string& first, const std::string& second) {
    EXPECT_THAT(groups(view), ElementsAre(first, second));
    ASSERT_THAT(view.loci, SizeIs(2)) << first;
    for (const std::size_t k : {0u, 1u}) {
        EXPECT_THAT(view.loci[k].points, SizeIs(4));
        ASSERT_TRUE(view.loci[k].line);
        EXPECT_THAT(view.loci[k].line->cohesion, DoubleNear(k == 0 ? 200 : 380, 1e-6)) << first;
    }
}

TEST(StressesBeside, HaveTheirOwnWordsBehindTheNameOrBeforeIt) {
    const std::string load = "Normal stress [kPa];";
    for (const char* const names : {"Shear stress dry [kPa];Shear stress 2 % oil [kPa]\n",
                                    "tau dry [kPa];tau 2 % oil [kPa]\n",
                                    "dry shear stress [kPa];2 % oil shear stress [kPa]\n",
                                    "Shear stress (kPa) - dry;Shear stress (kPa) - 2 % oil\n",
                                    "Shear stress (dry) / kPa;Shear stress (2 % oil) / kPa\n",
                                    "Shear stress_dry [kPa];Shear stress_2 % oil [kPa]\n"})
        expect_two(points(load + names + rows(2)), "dry", "2 % oil");
    std::string decimal_commas = rows(2);
    std::ranges::replace(decimal_commas, '.', ',');
    expect_two(points("Contrainte normale (kPa);Contrainte de cisaillement sec (kPa);"
                      "Contrainte de cisaillement eau (kPa)\n" +
                      decimal_commas),
               "sec", "eau");
    expect_two(points(load + "Shear stress 3 kPa [kPa];Shear stress 6 kPa [kPa]\n" + rows(2)),
               "3 kPa", "6 kPa");
}

TEST(StressesBeside, MayHaveTheirNameOnceOverTheColumns) {
    expect_two(points("Scherversuche, Labor K\n\n;Schubspannung [kPa];\nNormalspannung [kPa];"
                      "Glas 1 mm;Sand\n" +
                      rows(2)),
               "Glas 1 mm", "Sand");
    expect_two(points("Normal stress;Shear stress;\nkPa;kPa;kPa\n;dry;wet\n" + rows(2)), "dry",
               "wet");
    // Spreadsheets end each line with the delimiters of empty columns.
    std::string text =
        "Ring shear;;;;\n;;;;\n;Shear stress [kPa];;;\nNormal stress [kPa];dry;wet;;\n";
    for (const double load : {1.0, 2.0, 3.0, 4.0})
        text += fmt::format("{};{:.2f};{:.2f};;\n", load, 0.2 + 0.51 * load, 0.38 + 0.51 * load);
    expect_two(points(text), "dry", "wet");
}

TEST(StressesBeside, KeepTheirErrorsAndLackValues) {
    const FileView errors =
        points("Normal stress [kPa];Shear stress dry [kPa];SD;Shear stress wet [kPa];SD\n" +
               rows(2, ";0.05"));
    expect_two(errors, "dry", "wet");
    EXPECT_TRUE(errors.file.blocks.back().columns.back().of_errors);
    const FileView lacking = points(
        "Normal stress [kPa];Shear stress dry [kPa];Shear stress wet [kPa]\n1;0.71;0.89\n"
        "2;1.22;\n3;1.73;1.91\n4;2.24;2.42\n5;2.75;2.93\n");
    ASSERT_THAT(lacking.loci, SizeIs(2));
    EXPECT_THAT(lacking.loci[0].points, SizeIs(5));
    EXPECT_THAT(lacking.loci[1].points, SizeIs(4));
}

TEST(StressesBeside, AreNoGroupsWhereTheirWordsAreStatistics) {
    for (const char* const names : {"Shear stress mean [kPa];Shear stress raw [kPa]\n",
                                    "Shear stress left [kPa];Shear stress right [kPa]\n",
                                    "Shear stress test 1 [kPa];Shear stress dry [kPa]\n"})
        EXPECT_THAT(points(std::string("Normal stress [kPa];") + names + rows(2)).loci,
                    testing::AnyOf(IsEmpty(), SizeIs(1)))
            << names;
    std::string series = "Time [s];Normal stress [Pa];Shear stress A [Pa];Shear stress B [Pa]\n";
    for (int i = 0; i < 50; ++i)
        series += fmt::format("{};2000;{};{}\n", i, 1000 + i % 3, 900 + i % 5);
    EXPECT_THAT(groups(points(series)), ElementsAre(""));
}

TEST(StressesBeside, ThatAreNumberedRepeatEachLoad) {
    for (const char* const names :
         {"Shear stress 1 [kPa];Shear stress 2 [kPa]\n", "Test 1 τ [kPa];Test 2 τ [kPa]\n",
          "Shear stress [kPa] n°1;Shear stress [kPa] n°2\n"}) {
        const FileView view = points(std::string("Normal stress [kPa];") + names + rows(2));
        EXPECT_THAT(groups(view), ElementsAre("repetitions")) << names;
        ASSERT_THAT(view.loci, SizeIs(1)) << names;
        EXPECT_THAT(view.loci[0].points, SizeIs(8));
        EXPECT_THAT(view.loci[0].line->cohesion, DoubleNear(290, 1e-6));
    }
}

/// Whether such a column holds errors was asked before the decimal mark of the file was known.
TEST(ErrorsBehindTheirValues, MayHaveDecimalCommas) {
    for (const char* const name :
         {"SD [kPa]", "Écart-type [kPa]", "Errore [kPa]", "Fehler [kPa]"}) {
        const FileView view =
            points(fmt::format("Normalspannung [kPa];Schubspannung [kPa];{}\n1,0;0,71;0,05\n"
                               "2,0;1,22;0,05\n3,0;1,73;0,06\n",
                               name));
        EXPECT_TRUE(view.file.blocks.front().columns.back().of_errors) << name;
    }
}

TEST(ErrorsBehindTheirValues, MayBePercentOfThem) {
    for (const char* const names :
         {"Tensión normal [kPa];Tensión de corte [kPa];Incertidumbre [%]",
          "Normalspannung [kPa];Schubspannung [kPa];Fehler der Schubspannung [%]"}) {
        const FileView view =
            points(fmt::format("{}\n1,0;0,80;2\n2,0;1,22;2\n3,0;1,73;5\n", names));
        const Block& block = view.file.blocks.front();
        EXPECT_TRUE(block.columns.back().of_errors) << names;
        const auto error =
            Columns(block.table).standard_error(block.table.rows.front(), "shear_stress");
        EXPECT_THAT(error.value_or(0), DoubleNear(16, 1e-9)) << names;
    }
}

TEST(ErrorsBehindTheirValues, HaveNamesOfStatistics) {
    for (const auto& [name, cell, expected] :
         {std::tuple("Standard error [kPa]", "0.03", 30.0),
          std::tuple("tau_err [kPa]", "0.03", 30.0), std::tuple("CV [%]", "5", 40.0),
          std::tuple("95 % CI [kPa]", "0.0392", 20.0),
          std::tuple("Expanded uncertainty [kPa]", "0.0392", 20.0),
          std::tuple("2σ [kPa]", "0.0392", 20.0), std::tuple("SD [kPa];n", "0.03;9", 10.0)}) {
        const FileView view = points(
            fmt::format("Normal stress [kPa];{1} [kPa];{0}\n1;0.8;{2}\n2;1.4;{2}\n3;2;{2}\n", name,
                        std::string(name).starts_with("tau") ? "tau" : "Shear stress", cell));
        const Block& block = view.file.blocks.front();
        const auto error =
            Columns(block.table).standard_error(block.table.rows.front(), "shear_stress");
        EXPECT_THAT(error.value_or(0), DoubleNear(expected, 0.01)) << name;
    }
}

/// Cells behind the last text of such a row do not exist; it was read beyond its end.
TEST(RowsBelowATable, MayHaveNoText) {
    EXPECT_THAT(points("Normal stress [kPa];Shear stress [kPa]\n" + rows(1) + ";\n;\n").loci,
                SizeIs(1));
}

}  // namespace pendular::data_stresses_beside_test
