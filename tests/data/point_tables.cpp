// Tables of points of failure as people write them: groups that are named once, preshears that a
// column marks in its own way, lines of means, and numbers that stand for no value.
#include <fmt/format.h>

#include "data/recordings/file_view.h"
#include "data/remarks/wording.h"
#include "tests/support/golden.h"

namespace pendular::data_point_tables_test {

using testing::IsEmpty;
using testing::SizeIs;

FileView points(const std::string& text, const std::string& name = "points.csv") {
    const TemporaryFolder folder;
    return view_of_file(folder.write(name, text));
}

std::vector<std::string> told(const FileView& view) {
    std::vector<std::string> texts;
    for (const Remark& finding : view.findings)
        texts.push_back(with_lines(finding, 9));
    return texts;
}

/// Cohesions [Pa] of the loci of a table.
std::vector<double> cohesions(const FileView& view) {
    std::vector<double> result;
    for (const YieldLocus& locus : view.loci)
        result.push_back(locus.line ? locus.line->cohesion : -1);
    return result;
}

/// Points on 200 Pa + 0.51 s and on 380 Pa + 0.51 s, whose group stands in its first row alone.
std::string grouped(const std::string& name, const std::string& first, const std::string& second) {
    return name + ";Normalspannung [kPa];Scherspannung [kPa]\n" + first + ";1,0;0,71\n;2,0;1,22\n" +
           ";3,0;1,73\n" + second + ";2,0;1,40\n;4,0;2,42\n;6,0;3,44\n";
}

/// Merged cells leave all but their first row empty in a CSV file.
TEST(GroupsNamedOnce, AreFilledDown) {
    for (const auto& [name, first, second] :
         {std::tuple("Vorscherspannung [kPa]", "4", "8"), std::tuple("Material", "Sand", "Mehl"),
          std::tuple("Probe", "1", "2"), std::tuple("Charge", "A7", "A9"),
          std::tuple("Wandmaterial", "Stahl", "PTFE")}) {
        const FileView view = points(grouped(name, first, second));
        EXPECT_THAT(cohesions(view), testing::Pointwise(testing::DoubleNear(1e-6), {200.0, 380.0}))
            << name;
    }
    expect_told(told(points(grouped("Material", "Sand", "Mehl"))));
    // Both stresses of the preshear stand once.
    const FileView both = points(
        "sigma pre [Pa],tau pre [Pa],Normal stress [Pa],Shear stress [Pa]\n4000,2100,1000,710\n"
        ",,2000,1220\n,,3000,1730\n");
    ASSERT_THAT(both.loci, SizeIs(1));
    EXPECT_EQ(both.loci[0].preshear->shear_stress, 2100);
}

TEST(GroupsNamedOnce, AreNotGuessedWhereRowsRepeatThem) {
    expect_told({input_error([] {
                     points(
                         "Sample,Normal stress [kPa],Shear stress [kPa]\nSand,1,0.71\nSand,2,1.22\n"
                         ",3,1.73\nFlour,1,1.10\nFlour,2,1.42\nFlour,3,1.74\n");
                 }),
                 input_error([] {
                     points(
                         "Material;Vorscherspannung [kPa];Normalspannung [kPa];Scherspannung "
                         "[kPa]\nQuarz;5;1;0,71\n;;2;1,22\n;;3;1,73\nKaolin;;1;1,1\n;;2;1,42\n"
                         ";;3;1,74\n");
                 })});
}

/// Preshears at 9 kPa before points at 7, 5, 3 and 2 kPa.
std::string marked(const std::string& name, const std::string& preshear, const std::string& shear) {
    std::string text = "Normal stress [kPa],Shear stress [kPa]," + name + "\n";
    const double loads[] = {7, 5, 3, 2}, peaks[] = {4.52, 3.49, 2.41, 1.88};
    for (int i = 0; i < 4; ++i)
        text +=
            fmt::format("9,{},{}\n{},{},{}\n", 4.9 + 0.01 * i, preshear, loads[i], peaks[i], shear);
    return text;
}

TEST(MarkedPreshears, AreNoPointsOfFailure) {
    for (const auto& [name, preshear, shear] :
         {std::tuple("Note", "preshear", ""), std::tuple("Remark", "consolidation", ""),
          std::tuple("Type", "P", "S"), std::tuple("Art", "Anscheren", "Abscheren"),
          std::tuple("Remark", "steady state", "peak"), std::tuple("Preshear?", "yes", "no"),
          std::tuple("preshear", "1", "0"), std::tuple("Vorscheren", "ja", ""),
          std::tuple("Comment", "steady-state flow", "incipient flow"),
          std::tuple("Point", "pre", "s1"), std::tuple("Phase", "stationär", "Peak"),
          std::tuple("Preshear", "TRUE", "FALSE"), std::tuple("Type", "PC", "C"),
          std::tuple("Preshear", "x", ""), std::tuple("Estado", "crítico", "pico"),
          std::tuple("Preshear", "3", "0")}) {
        const FileView view = points(marked(name, preshear, shear));
        EXPECT_THAT(cohesions(view), testing::ElementsAre(testing::DoubleNear(826, 1)))
            << name << " " << preshear;
        ASSERT_THAT(view.loci, SizeIs(1));
        ASSERT_TRUE(view.loci[0].preshear) << name;
        // The preshear is the mean over all of its rows.
        EXPECT_NEAR(view.loci[0].preshear->shear_stress, 4915, 1e-6);
        EXPECT_NEAR(view.loci[0].preshear->shear_stress_error.value(), 12.91 / 2, 0.01);
    }
}

TEST(MarkedPreshears, AreNotGuessedFromLetters) {
    // P and S are materials here, and steady states follow peaks at the same load.
    EXPECT_THAT(points("Powder,Normal stress [kPa],Shear stress [kPa]\nP,1,0.71\nP,2,1.22\n"
                       "P,3,1.73\nS,1,1.10\nS,2,1.42\nS,3,1.74\n")
                    .loci,
                SizeIs(2));
    const FileView view = points(
        "Normal stress [kPa],Shear stress [kPa],State\n1,0.71,peak\n1,0.5,steady state\n"
        "2,1.22,peak\n2,1.0,steady state\n3,1.73,peak\n3,1.5,steady state\n");
    EXPECT_THAT(cohesions(view), testing::ElementsAre(testing::DoubleNear(200, 1e-6)));
    EXPECT_FALSE(view.loci[0].preshear);
}

/// Without a mark, the file is read as it stands, and said to be doubtful.
TEST(UnmarkedPreshears, AreTold) {
    expect_told(told(points(marked("Nr", "1", "2"))));
    // Two levels of preshears.
    expect_told(told(points(
        "Normal stress [kPa],Shear stress [kPa]\n5,3.4\n1,1.12\n5,3.4\n2,1.84\n5,3.4\n3,2.46\n"
        "10,6.8\n2,2.2\n10,6.8\n4,3.7\n10,6.8\n6,4.9\n")));
    EXPECT_THAT(told(points("Normal stress [kPa],Shear stress [kPa]\n1,0.7\n2,1.2\n3,1.7\n1,0.71\n"
                            "2,1.21\n3,1.71\n")),
                IsEmpty());
}

TEST(PreshearsAboveATable, AreThoseOfItsPoints) {
    const FileView view = points(
        "Schulze ring shear tester\nPreshear normal stress: 5 kPa\nPreshear shear stress: 3400 Pa\n"
        "Normal stress [Pa];Shear stress [Pa]\n1000;1120\n2000;1840\n3000;2460\n4000;2990\n");
    ASSERT_THAT(view.loci, SizeIs(1));
    ASSERT_TRUE(view.loci[0].preshear);
    EXPECT_EQ(view.loci[0].preshear->normal_stress, 5000);
    EXPECT_EQ(view.loci[0].preshear->shear_stress, 3400);
}

/// Lines of a mean or a scatter, in any language where the rows are counted.
TEST(LinesOfStatistics, AreNoPoints) {
    for (const std::string first : {"1\n2\n3\n4", "P1\nP2\nP3\nP4"}) {
        for (const std::string end :
             {"Summe;10,0;5,90\nMittelwert;2,5;1,475\nStabw;1,29;0,66\n", "Stabw;1,29;0,66\n",
              "n;4;4\nMean;2,5;1,475\nSD;1,29;0,66\nMax;4,0;2,24\n",
              "Średnia;2,5;1,475\nOdch. std.;1,29;0,66\n", "平均;2,5;1,475\n",
              "Gemiddelde;2,5;1,475\nVarianz;1,66;0,43\nRSD;0,5;0,4\n"}) {
            std::istringstream labels(first);
            std::string text = "Nr;Normalspannung [kPa];Scherspannung [kPa]\n", label;
            for (const char* const point : {"1,0;0,71", "2,0;1,22", "3,0;1,73", "4,0;2,24"}) {
                std::getline(labels, label);
                text += label + ";" + point + "\n";
            }
            const FileView view = points(text + end);
            EXPECT_THAT(cohesions(view), testing::ElementsAre(testing::DoubleNear(200, 1e-6)))
                << first << end;
        }
    }
    EXPECT_THAT(cohesions(points("Nr;Normalspannung [kPa];Scherspannung [kPa]\n1;1,0;0,71\n"
                                 "2;2,0;1,22\n3;3,0;1,73\nSzórás;1;0,5\n")),
                testing::ElementsAre(testing::DoubleNear(200, 1e-6)));
}

// Points on 200 Pa + 0.51 s with labels, and further rows below them.
std::string labelled(const std::string& below) {
    return "Sample;Normal stress [kPa];Shear stress [kPa]\nA1;1;0.71\nA2;2;1.22\nA3;3;1.73\n"
           "A4;4;2.24\n" +
           below;
}

TEST(LinesOfStatistics, AreToldInAnyLanguageByTheirNumbers) {
    for (const char* const below :
         {"Průměr;2.5;1.475\nSměrodatná odchylka;1.29;0.66\n", "Keskiarvo;2.5;1.48\n",
          "Mean (n=4);2.5;1.475\nSD (n=4);1.29;0.658\n", "Μέσος;2.500;1.475\n",
          "x̄;2.5;1.475\ns;1.29;0.658\n", "Rel. std. dev.;0.516;0.446\n", "N;4;4\n"})
        EXPECT_THAT(cohesions(points(labelled(below))),
                    testing::ElementsAre(testing::DoubleNear(200, 1e-6)))
            << below;
    // The label stands in the last column.
    EXPECT_THAT(cohesions(points("Normal stress [kPa];Shear stress [kPa];Remark\n1;0.71;\n2;1.22;\n"
                                 "3;1.73;\n4;2.24;\n2.5;1.475;mean\n1.29;0.66;SD\n")),
                testing::ElementsAre(testing::DoubleNear(200, 1e-6)));
}

TEST(LinesOfStatistics, AreNoSamplesWithSuchNames) {
    const auto rows = [](const std::string& text) {
        std::size_t all = 0;
        for (const YieldLocus& locus : points(text).loci)
            all += locus.points.size();
        return all;
    };
    EXPECT_EQ(rows(labelled("Mean flow;5;2.8\n")), 5);
    EXPECT_EQ(rows(labelled("Max-1;5;2.8\nMax-2;6;3.3\n")), 6);
    EXPECT_EQ(rows(labelled("Minette;5;2.8\nSumatra;6;3.3\nMaxit;7;3.8\n")), 7);
    EXPECT_EQ(rows(labelled("N;5;2.8\n")), 5);
    EXPECT_EQ(rows(labelled("SD;1;0.6\nSD;2;1.0\nSD;3;1.4\n")), 7) << "a sample of three points";
}

/// Points on 200 Pa + 0.51 s below a first title, and on 380 Pa + 0.51 s below a second one.
std::string titled(const std::string& first, const std::string& second) {
    return "Nr;Normal stress [Pa];Shear stress [Pa]\n" + first + "1;1000;710\n2;2000;1220\n" +
           "3;3000;1730\n" + second + "1;2000;1400\n2;4000;2420\n3;6000;3440\n";
}

TEST(TitlesBetweenRows, PartTheLociOfATable) {
    for (const auto& [first, second] :
         {std::pair("Sand A;;\n", "Sand B;;\n"), std::pair("", "Sand B\n"),
          std::pair(";Sand A;\n", "\n;Sand B;\n")}) {
        const FileView view = points(titled(first, second));
        EXPECT_THAT(cohesions(view), testing::Pointwise(testing::DoubleNear(1e-6), {200.0, 380.0}))
            << first << second;
    }
    const FileView view = points(titled("Sand A;;\n", "Sand B;;\n"));
    ASSERT_THAT(view.loci, SizeIs(2));
    EXPECT_EQ(view.loci[1].test, "Sand B");
    EXPECT_THAT(points(titled("Sand A;;\n", "") + "End of data;;\n").loci, SizeIs(1));
    std::string five = titled("Sand A;;\n", "Sand B;;\n");
    for (const char* const title : {"Sand C;;\n", "Sand D;;\n", "Sand E;;\n"})
        five += std::string(title) + "1;1000;710\n2;2000;1220\n3;3000;1730\n";
    EXPECT_THAT(points(five).loci, SizeIs(5));
}

TEST(LiquidContents, PartTheLociOfATable) {
    const FileView view = points(
        "Liquid content [%];Normal stress [kPa];Shear stress [kPa]\n0;1;0.71\n0;2;1.22\n0;3;1.73\n"
        "5;1;1.11\n5;2;1.62\n5;3;2.13\n");
    EXPECT_THAT(cohesions(view), testing::Pointwise(testing::DoubleNear(1e-6), {200.0, 600.0}));
    ASSERT_THAT(view.loci, SizeIs(2));
    EXPECT_EQ(view.loci[1].points[0].liquid_content, 0.05);
    // One content for all parts nothing.
    EXPECT_THAT(points("Liquid content [%];Normal stress [kPa];Shear stress [kPa]\n5;1;1.11\n"
                       "5;2;1.62\n5;3;2.13\n")
                    .loci,
                SizeIs(1));
}

TEST(NumbersForNoValue, AreValuesWhereTheyGoWithTheOthers) {
    const auto count = [](const std::string& rows) {
        const FileView view = points("Normal stress [Pa],Shear stress [Pa]\n" + rows);
        return view.loci.empty() ? 0 : view.loci[0].points.size();
    };
    EXPECT_EQ(count("50,40\n100,80\n200,160\n300,240\n999,799\n"), 5);
    EXPECT_EQ(count("1000,530\n2000,1060\n3000,1590\n9999,5300\n"), 4);
    EXPECT_EQ(count("1000,530\n2000,1060\n3000,1590\n9999,9999\n"), 4) << "a ratio of 1";
    EXPECT_EQ(count("100,53\n200,106\n300,159\n400,9999\n"), 3);
    EXPECT_EQ(count("100,53\n200,106\n300,159\n-999,-999\n"), 3);
    // Tension, and shear in the other sense.
    EXPECT_EQ(count("-100,150\n100,250\n200,300\n"), 3);
    EXPECT_EQ(count("100,53\n200,106\n300,159\n100,-54\n200,-107\n"), 5);
}

TEST(NumbersForNoValue, AreNoPoints) {
    const FileView view = points(
        "Normal stress [kPa],Shear stress [kPa]\n1,0.71\n2,-999\n3,1.73\n4,-999\n5,2.75\n6,3.26\n");
    EXPECT_THAT(cohesions(view), testing::ElementsAre(testing::DoubleNear(200, 1e-6)));
    std::vector<std::string> texts = told(view);
    for (const std::string& text :
         told(points("Normal stress [Pa],Shear stress [Pa]\n100,300\n200,200\n300,100\n")))
        texts.push_back(text);
    expect_told(texts);
    EXPECT_THAT(cohesions(points("Normal stress [kPa],Shear stress [kPa]\n1,0.71\n2,1.22\n"
                                 "3,1.73\n4,999\n")),
                testing::ElementsAre(testing::DoubleNear(200, 1e-6)));
    // A tester that turns the other way.
    EXPECT_THAT(told(points("Normal stress [kPa],Shear stress [kPa]\n1,-0.7\n2,-1.2\n3,-1.7\n")),
                IsEmpty());
}

/// Points of two tests at the same loads, on 200 Pa + 0.51 s and 600 Pa + 0.51 s, which a column
/// tells apart.
std::string told_apart_by(const std::string& name, const std::string& first = "9",
                          const std::string& second = "12") {
    std::string text = name + ";Normal stress [kPa];Shear stress [kPa]\n";
    for (const auto& [value, more] : {std::pair(first, 0.0), std::pair(second, 0.4)})
        for (const double load : {1.0, 2.0, 3.0, 4.0})
            text += fmt::format("{};{};{}\n", value, load, 0.2 + 0.51 * load + more);
    return text;
}

TEST(LevelsOfConsolidation, ArePreshears) {
    for (const char* const name :
         {"Charge de précisaillement (kPa)", "Pre-consolidation normal stress [kPa]",
          "Consolidation (kPa)", "Préconsolidation (kPa)", "Tension de préconsolidation (kPa)",
          "Precarico (kPa)", "Nivel de consolidación (kPa)", "Sforzo di consolidazione [kPa]"}) {
        const FileView view = points(told_apart_by(name));
        ASSERT_THAT(view.loci, SizeIs(2)) << name;
        ASSERT_TRUE(view.loci[1].preshear) << name;
        EXPECT_EQ(view.loci[1].preshear->normal_stress, 12000) << name;
    }
    // Without a unit, numbers of levels are no stresses.
    EXPECT_THAT(points(told_apart_by("Consolidation level", "1", "2")).loci, SizeIs(2));
    EXPECT_FALSE(points(told_apart_by("Consolidation level", "1", "2")).loci[0].preshear);
}

/// Most water contents are ratios of masses, and none is taken for a liquid content.
TEST(WaterContents, PartTheLociOfATable) {
    for (const char* const name :
         {"Water content (%)", "Teneur en eau (%)", "w (%)", "Umidità (%)", "Contenuto d'acqua [%]",
          "Humedad (%)", "Taux de liquide (ml/g)", "Wassergehalt [%]", "Feuchte (%)"}) {
        const FileView view = points(told_apart_by(name, "0", "2"));
        EXPECT_THAT(cohesions(view), testing::Pointwise(testing::DoubleNear(1e-6), {200.0, 600.0}))
            << name;
        EXPECT_FALSE(view.loci[1].points[0].liquid_content) << name;
    }
    EXPECT_EQ(points(told_apart_by("Water content (%)", "0", "2")).loci[1].test,
              "Water content 2 %");
}

TEST(ColumnsOfNumbers, PartLociOrAreTold) {
    for (const char* const name :
         {"Essai n°", "Prueba", "Level", "Niveau", "Preshear level", "Diamètre (mm)",
          "Diameter [mm]", "Temperature [°C]", "Humidité relative (%)", "Velocity (mm/min)"})
        EXPECT_THAT(points(told_apart_by(name, "1", "2")).loci, SizeIs(2)) << name;
    for (const char* const name : {"Repeat", "Wiederholung", "Xyz", "Operator"})
        EXPECT_THAT(points(told_apart_by(name, "1", "2")).loci, SizeIs(1)) << name;
    expect_told(told(points(told_apart_by("Repeat", "1", "2"))));
    // A temperature that drifts, and a counter of rows.
    EXPECT_THAT(told(points("Nr;Temperature [°C];Normal stress [kPa];Shear stress [kPa]\n"
                            "1;22.1;1;0.7\n2;22.1;2;1.2\n3;22.3;3;1.7\n4;22.3;4;2.2\n")),
                IsEmpty());
}

/// Rows sorted by load, as spreadsheets leave them.
std::string sorted_repeats(int repeats, const std::string& mean = "") {
    std::string text = "Normal stress [kPa];Shear stress [kPa];n\n";
    for (const double load : {2.0, 4.0, 6.0, 8.0}) {
        for (int k = 0; k < repeats; ++k)
            text += fmt::format("{};{:.4f};{}\n", load,
                                0.2 + 0.51 * load + 0.02 * (k - (repeats - 1) / 2.0), k + 1);
        if (!mean.empty()) text += fmt::format("{};{:.4f};{}\n", load, 0.2 + 0.51 * load, mean);
    }
    return text;
}

TEST(RepeatsSortedByLoad, ArePoints) {
    for (const int repeats : {2, 3, 4, 5, 8}) {
        const FileView view = points(sorted_repeats(repeats));
        ASSERT_THAT(view.loci, SizeIs(1)) << repeats;
        EXPECT_EQ(std::ssize(view.loci[0].points), 4 * repeats);
        EXPECT_THAT(cohesions(view), testing::ElementsAre(testing::DoubleNear(200, 1e-6)));
    }
}

TEST(LinesOfStatistics, StandBelowEachGroup) {
    for (const int repeats : {2, 3})
        for (const char* const mean : {"mean", "moyenne", "Mittelwert"}) {
            const FileView view = points(sorted_repeats(repeats, mean));
            ASSERT_THAT(view.loci, SizeIs(1)) << mean;
            EXPECT_EQ(std::ssize(view.loci[0].points), 4 * repeats) << mean;
        }
}

const std::string four_points =
    "Contrainte normale (kPa);Contrainte de cisaillement (kPa)\n2.0;1.25\n4.0;2.33\n6.0;3.38\n"
    "8.0;4.47\n";

TEST(LinesOfStatistics, MayHaveNoLabel) {
    for (const char* const below : {"5.0;2.8575\n2.58199;1.38268\n", "5.0;2.8575\n"})
        EXPECT_THAT(points(four_points + below).loci.at(0).points, SizeIs(4)) << below;
    EXPECT_THAT(points(four_points + "5.0;2.86\n").loci.at(0).points, SizeIs(5))
        << "a point with as many decimals as the others";
}

TEST(ResultsBelowPoints, AreNoPoints) {
    for (const char* const below :
         {"pente;0.5355\nordonnée;0.18\nangle (°);28.2\n", "\ntan φ;0.5355\nc (kPa);0.18\n",
          "\nc;0.18\nphi;28.2\n", "R²;0.999\n", "\nCoesione (kPa);0.18\nAngolo;28.2\n",
          "slope;0.5355\nintercept;0.18\n", "\nSteigung;0.5355\nAchsenabschnitt;0.18\n",
          "\nNiveau;FFc\n1;5.2\n2;6.3\n",
          "\nContrainte principale majeure (kPa);Résistance non confinée (kPa)\n9.1;0.6\n"
          "18.2;1.0\n"}) {
        const FileView view = points(four_points + below);
        ASSERT_THAT(view.loci, SizeIs(1)) << below;
        EXPECT_THAT(view.loci[0].points, SizeIs(4)) << below;
        EXPECT_FALSE(view.file.skipped.empty()) << below;
    }
    // Samples whose names are those letters.
    EXPECT_THAT(points("Sample;Normal stress [kPa];Shear stress [kPa]\nA;1;0.71\nB;2;1.22\n"
                       "C;3;1.73\nR;4;2.24\n")
                    .loci.at(0)
                    .points,
                SizeIs(4));
}

TEST(TitlesBetweenRows, MayStatePreshears) {
    const FileView view = points(titled("Pretaglio 4 kPa;;\n", "Pretaglio 8 kPa;;\n"));
    ASSERT_THAT(view.loci, SizeIs(2));
    ASSERT_TRUE(view.loci[0].preshear && view.loci[1].preshear);
    EXPECT_EQ(view.loci[0].preshear->normal_stress, 4000);
    EXPECT_EQ(view.loci[1].preshear->normal_stress, 8000);
    for (const char* const title :
         {"Sand 4 kPa;;\n", "Preshear 4 kPa, shear stress 2 kPa;;\n", "Preshear 4;;\n"})
        EXPECT_FALSE(points(titled(title, "Sand B;;\n")).loci.at(0).preshear) << title;
}

TEST(NamesOfStresses, SayHowTheyWereRead) {
    for (const auto& [normal, shear] :
         {std::pair("Contrainte normale nominale (kPa)", "Contrainte de cisaillement au pic (kPa)"),
          std::pair("Tensión normal (kPa)", "Resistencia al corte (kPa)"),
          std::pair("Sforzo normale (kPa)", "Resistenza di picco (kPa)"),
          std::pair("Sforzo normale (kPa)", "Sforzo di taglio medio (kPa)"),
          std::pair("Normal stress [kPa]", "Shear stress peak [kPa]"),
          std::pair("Normal stress [kPa]", "Mean shear stress [kPa]")})
        EXPECT_THAT(
            cohesions(points(fmt::format("{};{}\n1;0.71\n2;1.22\n3;1.73\n", normal, shear))),
            testing::ElementsAre(testing::DoubleNear(200, 1e-6)))
            << shear;
}

TEST(MissingPoints, HaveMarksOfOtherLanguages) {
    for (const char* const mark : {"#N/D", "s/d", "n.m.", "s.o.", "n.c."})
        EXPECT_THAT(points("Normal stress [kPa];Shear stress [kPa]\n1;0.71\n2;" +
                           std::string(mark) + "\n3;1.73\n4;2.24\n")
                        .loci.at(0)
                        .points,
                    SizeIs(3))
            << mark;
}

}  // namespace pendular::data_point_tables_test
