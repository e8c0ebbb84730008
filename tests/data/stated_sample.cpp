// What lines above a table and columns of a recording state of the cell, the beads and the liquid.
#include "data/recordings/stated_sample.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <chrono>
#include <cmath>

#include "data/input_error.h"
#include "data/recordings/file_view.h"
#include "data/remarks/wording.h"
#include "tests/support/data_support.h"

namespace pendular::data_stated_sample_test {

using testing::HasSubstr;

const std::string names = "Time [s];Speed [rpm];Normal force [N];Torque [mNm];Gap [mm]";

class StatedSample : public testing::Test {
  protected:
    /// A recording below some lines, with one more column whose cell may differ in the second half.
    FileView view(const std::string& above, const std::string& column = "",
                  const std::string& first = "", const std::string& second = "") {
        std::string text = above + names + (column.empty() ? "" : ";" + column) + "\n";
        for (int i = 0; i < 60; ++i)
            text += fmt::format("{};0,95;5,0{};2{},1;12,0{}{}\n", i, i % 7, i % 5, i % 3,
                                column.empty() ? "" : ";" + (i < 30 ? first : second));
        return view_of_file(folder_.write("t.csv", text));
    }
    double radius(const std::string& above, std::optional<StatedValue> StatedCell::*member) {
        const FileView seen = view(above);
        return seen.stated.*member ? (seen.stated.*member)->value : 0;
    }

    TemporaryFolder folder_;
};

TEST_F(StatedSample, HasRadiiWithNamesInFiveLanguages) {
    for (const char* const above :
         {"Raggio interno: 20 mm\nRaggio esterno: 40 mm\n\n",
          "Radio interior: 20 mm\nRadio exterior: 40 mm\n\n",
          "Rayon int. (mm);20\nRayon ext. (mm);40\n\n",
          "Innenradius: 20 mm\nAußenradius: 40 mm\n\n",
          "Diametro interno [mm]: 40\nDiametro esterno [mm]: 80\n\n",
          "Ø int. = 40 mm\nØ ext. = 80 mm\n\n",
          "Diámetro interior: 4 cm\nDiámetro exterior: 8 cm\n\n", "D_i = 40 mm\nD_o = 80 mm\n\n",
          "Cell: r_i 20 mm\nr_o 40 mm\n\n", "r_i = 20 mm, r_o = 40 mm\n\n",
          "Inner radius 20 mm, outer radius 40 mm\n\n", "Inner/outer diameter: 40/80 mm\n\n",
          "Innen-/Außendurchmesser: 40/80 mm\n\n", "ID: 40 mm\nOD: 80 mm\n\n",
          "Cell inner diameter (mm): 40\nOuter radius of the cell: 40 mm\n\n",
          "Inner radius;mm;20\nOuter radius;40;mm\n\n",
          "Inner radius: 20\nOuter radius: 40\nUnits: mm\n\n",
          "Inner diameter / outer diameter: 40 / 80 mm\n\n"}) {
        EXPECT_NEAR(radius(above, &StatedCell::inner_radius), 0.02, 1e-9) << above;
        EXPECT_NEAR(radius(above, &StatedCell::outer_radius), 0.04, 1e-9) << above;
    }
    EXPECT_EQ(radius("Rayon moyen : 30 mm\nn: 3\n\n", &StatedCell::inner_radius), 0);
}

TEST_F(StatedSample, HasBeadsWithNamesInFiveLanguages) {
    const auto sample = [&](const std::string& line) {
        return stated_sample(view(line + "\n\n").file);
    };
    for (const char* const line : {"Diamètre des billes : 1 mm", "Bead diameter: 1 mm",
                                   "Kugeldurchmesser [mm]: 1", "Diametro sfere: 0,1 cm"})
        EXPECT_NEAR(sample(line).diameter.value_or(StatedValue{}).value, 1e-3, 1e-9) << line;
    for (const char* const line : {"Density: 2460 kg/m3", "Masse volumique : 2460 kg/m³",
                                   "Dichte: 2,46 g/cm³", "Densità: 2460 kg/m³"})
        EXPECT_NEAR(sample(line).density.value_or(StatedValue{}).value, 2460, 1e-6) << line;
    for (const char* const line : {"Masse des billes : 120 g", "Bead mass: 120 g",
                                   "Massa sfere: 120 g", "Einwaage: 0,12 kg"})
        EXPECT_NEAR(sample(line).mass.value_or(StatedValue{}).value, 0.12, 1e-9) << line;
    const auto beads = sample("Material: glass beads, d = 0.8 mm, rho = 2460 kg/m³");
    EXPECT_NEAR(beads.diameter.value_or(StatedValue{}).value, 0.8e-3, 1e-12);
    EXPECT_NEAR(beads.density.value_or(StatedValue{}).value, 2460, 1e-9);
    EXPECT_EQ(beads.density->doubt, StatedDoubt::name);
    const auto liquid = sample("Surface tension: 65 mN/m\nContact angle: 20°");
    EXPECT_NEAR(liquid.surface_tension.value_or(StatedValue{}).value, 0.065, 1e-12);
    EXPECT_NEAR(liquid.contact_angle.value_or(StatedValue{}).value, M_PI / 9, 1e-12);
    EXPECT_FALSE(sample("Masse du couvercle : 120 g").mass);
    EXPECT_FALSE(sample("Bulk density: 1500 kg/m3").density);
}

TEST_F(StatedSample, HasALiquidAboveTheTable) {
    const auto liquid = [&](const std::string& line) {
        return stated_liquid(view(line + "\n\n").file).value_or(StatedLiquid{});
    };
    for (const char* const line :
         {"Liquid content: 2 %", "Teneur en liquide : 2 %", "Contenuto di liquido: 2 %",
          "Fraction volumique de liquide : 0,02", "Liquide : eau, 2 % vol",
          "Flüssigkeitsgehalt [%]: 2", "Contenido de líquido: 2"}) {
        EXPECT_NEAR(liquid(line).value, 0.02, 1e-9) << line;
        EXPECT_FALSE(liquid(line).by_mass) << line;
    }
    EXPECT_NEAR(liquid("Water content 2 %").value, 0.02, 1e-9);
    EXPECT_TRUE(liquid("Water content 2 %").by_mass);
    EXPECT_TRUE(liquid("Liquid content: 2 wt%").by_mass);
    EXPECT_EQ(liquid("Humidity: 45 %").value, 0);
    EXPECT_EQ(liquid("Liquid: water").value, 0);
}

TEST_F(StatedSample, HasALiquidInAColumn) {
    const auto of = [&](const char* first, const char* second) {
        return stated_liquid(view("", "Teneur en liquide (%)", first, second).file);
    };
    EXPECT_NEAR(of("1", "1")->value, 0.01, 1e-9);
    EXPECT_EQ(of("0", "0")->value, 0);
    EXPECT_FALSE(stated_liquid(view("").file));
    try {
        of("1", "3");
        ADD_FAILURE();
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("t.csv:32: the liquid content changes here from 0.01"));
    }
}

/// A person writes the numbers above a table in a style of his own, which a delimiter may split.
TEST_F(StatedSample, HasNumbersWithADecimalCommaInACommaSeparatedFile) {
    for (const char* const mark : {"", "# "}) {
        std::string text = mark + std::string("Reindichte: 2,5 g/cm³\n") + mark +
                           "Particle diameter: 1,5 mm\n" + mark + "Bead mass: 12,5 g\n" + mark +
                           "Innenradius: 10,5 mm,,,\n" + mark + "Wassergehalt: 1,5 %\n" +
                           "Time [s],Speed [rpm],Normal force [N],Torque [mNm],Gap [mm]\n";
        for (int i = 0; i < 60; ++i)
            text += fmt::format("{},0.95,5.0{},2{}.1,12.0{}\n", i, i % 7, i % 5, i % 3);
        const FileView seen = view_of_file(folder_.write("comma.csv", text));
        const auto sample = stated_sample(seen.file);
        EXPECT_NEAR(sample.density.value_or(StatedValue{}).value, 2500, 1e-6);
        EXPECT_NEAR(sample.diameter.value_or(StatedValue{}).value, 1.5e-3, 1e-12);
        EXPECT_NEAR(sample.mass.value_or(StatedValue{}).value, 0.0125, 1e-12);
        EXPECT_NEAR(seen.stated.inner_radius.value_or(StatedValue{}).value, 0.0105, 1e-12);
        EXPECT_NEAR(stated_liquid(seen.file).value_or(StatedLiquid{}).value, 0.015, 1e-12);
    }
}

/// The comma that divides two statements is the delimiter too.
TEST_F(StatedSample, HasRadiiInOneLineOfACommaSeparatedFile) {
    for (const char* const above :
         {"r_i = 15 mm, r_o = 30,5 mm", "Inner radius 15 mm, outer radius 30.5 mm"}) {
        std::string text = above + std::string("\nTime [s],Torque [mNm],Normal force [N]\n");
        for (int i = 0; i < 60; ++i)
            text += fmt::format("{},2{}.1,5.0{}\n", i, i % 5, i % 7);
        const FileView seen = view_of_file(folder_.write("one.csv", text));
        EXPECT_NEAR(seen.stated.inner_radius.value_or(StatedValue{}).value, 0.015, 1e-12) << above;
        EXPECT_NEAR(seen.stated.outer_radius.value_or(StatedValue{}).value, 0.0305, 1e-12) << above;
    }
}

TEST_F(StatedSample, IsNoProductOfTwoNumbers) {
    const auto mass = [&](const std::string& line) {
        return stated_sample(view(line + "\n\n").file).mass.value_or(StatedValue{}).value;
    };
    EXPECT_NEAR(mass("Bead mass: 12 500 mg"), 0.0125, 1e-12);
    EXPECT_NEAR(mass("Bead mass: 12\u202f500 mg"), 0.0125, 1e-12);
    EXPECT_NEAR(mass("Bead mass: 1.234,5 mg"), 0.0012345, 1e-12);
    EXPECT_NEAR(mass("Bead mass: 12,5 ± 0,1 g"), 0.0125, 1e-12);
    for (const char* const line :
         {"Bead mass: 2 50 g", "Bead mass;12;5 g", "Bead mass: 2 x 50 g", "Bead mass: 12,5,3 g"})
        EXPECT_EQ(mass(line), 0) << line;
}

/// The rows have decimal commas; who writes "1.250" above them may mean either.
TEST_F(StatedSample, IsInDoubtWhereAMarkMayBeEither) {
    const auto sample = [&](const std::string& line) {
        return stated_sample(view(line + "\n\n").file);
    };
    for (const char* const line : {"Density: 2.650 kg/m³", "Density: 2,650 kg/m³",
                                   "Density: 2,650 g/cm³", "Density: 2.650 g/cm³"}) {
        const StatedValue density = sample(line).density.value_or(StatedValue{});
        EXPECT_NEAR(density.value, 2650, 1e-6) << line;
        EXPECT_EQ(density.doubt, StatedDoubt::none) << line;
    }
    EXPECT_EQ(sample("Bead diameter: 1.250 µm").diameter->doubt, StatedDoubt::other_mark);
    EXPECT_EQ(sample("Bead diameter: 1,250 mm").diameter->doubt, StatedDoubt::none);
    const auto range = sample("Grain size: 0,4-0,6 mm").diameter.value_or(StatedValue{});
    EXPECT_NEAR(range.value, 0.5e-3, 1e-12);
    EXPECT_EQ(range.doubt, StatedDoubt::range);
}

TEST_F(StatedSample, HasNoDensityOfAPackingAndNoContentOfAMixture) {
    for (const char* const line :
         {"Density (loose): 1,45 g/cm³", "Density (bulk): 1,45 g/cm³",
          "Dichte (Schüttung): 1,5 g/cm³", "Densité (apparente): 1,5 g/cm³",
          "Density: 1,45 g/cm³ loose", "Density: 1,45 g/cm³, tapped 100 g"})
        EXPECT_FALSE(stated_sample(view(std::string(line) + "\n\n").file).density) << line;
    EXPECT_FALSE(stated_sample(view("Sample mass (wet): 14 g\n\n").file).mass);
    EXPECT_EQ(stated_sample(view("Density (glass): 2,5 g/cm³\n\n").file).density->doubt,
              StatedDoubt::name);
    for (const char* const line :
         {"Liquid: glycerol 60 wt% in water", "Liquid: 5 % NaCl in water", "Water: 95 %"})
        EXPECT_FALSE(stated_liquid(view(std::string(line) + "\n\n").file)) << line;
}

/// Points of failure on 200 Pa + 0.6 s below one line.
FileView points_below(const std::string& line) {
    const TemporaryFolder folder;
    return view_of_file(folder.write(
        "p.csv", line + "\nNormal stress [kPa],Shear stress [kPa]\n1,0.8\n2,1.4\n3,2.0\n4,2.6\n"));
}

TEST_F(StatedSample, HasAPreshearInOneLine) {
    for (const char* const line :
         {"Preshear: 5 kPa, 3.1 kPa", "Preshear stress 5 kPa / shear 3.1 kPa",
          "Vorscheren: σ = 5 kPa; τ = 3.1 kPa", "sigma_pre = 5 kPa, tau_pre = 3.1 kPa",
          "Preshear (kPa),5\nPreshear shear stress (kPa),3.1",
          "Preshear normal stress: 5,000 Pa\nPreshear shear stress: 3,100 Pa",
          "Preshear shear stress: 3 100 Pa\nPreshear normal stress: 5 000 Pa",
          "Preshear: 5.0 kPa (nominal 6 kPa), τ = 3.1 kPa"}) {
        const FileView view = points_below(line);
        ASSERT_EQ(view.loci.size(), 1u) << line;
        ASSERT_TRUE(view.loci[0].preshear) << line;
        EXPECT_NEAR(view.loci[0].preshear->normal_stress, 5000, 1e-9) << line;
        EXPECT_NEAR(view.loci[0].preshear->shear_stress, 3100, 1e-9) << line;
    }
    EXPECT_EQ(points_below("Preshear at 5 kPa").file.blocks[0].preshear_normal_stress, 5000);
    for (const char* const line : {"No preshear, 5 kPa at most", "Preshear: 2 kPa",
                                   "Preshear: 6 kPa, 5 kPa", "Preshear: 1 5 kPa"})
        EXPECT_FALSE(points_below(line).file.blocks[0].preshear_normal_stress) << line;
}

/// The search for names took a second for each such line.
TEST_F(StatedSample, IsSoughtQuicklyAmongBlanks) {
    BlockFile file;
    for (int i = 0; i < 100; ++i)
        file.add_fact({fmt::format("k{}", i), "a " + std::string(280, ' ') + "b", i + 1});
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_FALSE(stated_cell(file).inner_radius);
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(5));
}

/// Half of the rows at the largest torque are told of the file already, as of the study.
TEST_F(StatedSample, TellsOfATorqueThatIsCutOff) {
    std::string text = names + "\n";
    for (int i = 0; i < 120; ++i)
        text +=
            fmt::format("{};0,95;5,0{};{};12,0{}\n", i, i % 7, i < 55 ? 20 + i % 9 : 67.2, i % 3);
    std::ranges::replace(text, '.', ',');
    const FileView seen = view_of_file(folder_.write("sat.csv", text));
    ASSERT_EQ(seen.findings.size(), 1u);
    EXPECT_THAT(with_lines(seen.findings[0], 8),
                HasSubstr("the torque stands at its largest value, 67 mN m, in 54 % of the rows"));
}

}  // namespace pendular::data_stated_sample_test
