#include "data/study/study.h"

#include <numbers>

#include "tests/support/golden.h"

namespace pendular::data_study_test {

// Lines are counted in the tests below.
const std::string grains = grains_table, cell = cell_table(), readings = points_table;
const std::string liquid = R"([liquid]
surface_tension = "20.6 mN/m"
contact_angle = "5 deg"
viscosity = "50 mPa.s"
)";

class ReadStudy : public testing::Test {
  protected:
    ReadStudy() {
        for (const char* name : {"points.csv", "dry_2.csv", "dry_1.csv", "dry_10.csv"})
            folder_.write(name, "a\n1\n");
    }
    Study read(const std::string& content) {
        folder_.write("study.toml", content);
        return read_study(folder_.path());
    }
    std::string error(const std::string& content) {
        return input_error([&] { read(content); });
    }

    TemporaryFolder folder_;
};

TEST_F(ReadStudy, RefusesAMissingValueThatIsNoNumber) {
    const std::string entry = grains + cell + "[[recording]]\nfile = \"dry_1.csv\"\nmissing = ";
    EXPECT_EQ(read(entry + "[\"-999\", \"-99,9\"]\n").sources[0].format.missing.size(), 2u);
    expect_told({error(entry + "[\"-999\", \"none\"]\n")});
}

TEST_F(ReadStudy, ReadsEveryKeyInSi) {
    const Study study = read(grains + "youngs_modulus = \"3.3 GPa\"\npoisson_ratio = 0.32\n" +
                             liquid + cell + "torque_formula = \"as_printed\"\n" + R"([[recording]]
file = "dry_*.csv"
liquid_content = 0.0
bead_volume = "57 cm^3"
[[readings]]
file = "points.csv"
liquid_content = "3 %"
[model]
base = "rumpf"
calibrate = ["friction"]
fit_to = "all"
effects = []
bridge_force = "as_printed"
)");
    EXPECT_DOUBLE_EQ(study.grains.diameter, 500e-6);
    EXPECT_DOUBLE_EQ(study.grains.density, 1050);
    EXPECT_DOUBLE_EQ(*study.grains.youngs_modulus, 3.3e9);
    EXPECT_DOUBLE_EQ(study.grains.poisson_ratio, 0.32);
    EXPECT_DOUBLE_EQ(study.liquid->surface_tension, 20.6e-3);
    EXPECT_DOUBLE_EQ(study.liquid->contact_angle, 5 * std::numbers::pi / 180);
    EXPECT_DOUBLE_EQ(study.liquid->viscosity, 50e-3);
    EXPECT_DOUBLE_EQ(study.cell->inner_radius, 21e-3);
    EXPECT_DOUBLE_EQ(study.cell->outer_radius, 45e-3);
    EXPECT_DOUBLE_EQ(study.cell->bead_volume, 0.06 / 1050);
    EXPECT_EQ(study.cell->torque_formula, FormulaVariant::as_printed);
    ASSERT_EQ(study.sources.size(), 2u);
    EXPECT_EQ(study.sources[0].kind, Source::Kind::recording);
    EXPECT_EQ(*study.sources[0].liquid_content, 0);
    EXPECT_DOUBLE_EQ(*study.sources[0].bead_volume, 57e-6);
    EXPECT_EQ(study.sources[0].files,
              (std::vector{folder_.path() / "dry_1.csv", folder_.path() / "dry_2.csv",
                           folder_.path() / "dry_10.csv"}));
    EXPECT_EQ(study.sources[1].kind, Source::Kind::readings);
    EXPECT_DOUBLE_EQ(*study.sources[1].liquid_content, 0.03);
    EXPECT_EQ(study.model.base, "rumpf");
    EXPECT_EQ(study.model.fit_to, "all");
    EXPECT_EQ(study.model.bridge_force, FormulaVariant::as_printed);
}

TEST_F(ReadStudy, HasTheDocumentedDefaults) {
    const Study study = read(grains + readings);
    EXPECT_EQ(study.grains.youngs_modulus, std::nullopt);
    EXPECT_DOUBLE_EQ(study.grains.poisson_ratio, 0.3);
    EXPECT_FALSE(study.liquid || study.cell);
    EXPECT_EQ(study.model.base, "dem");
    EXPECT_EQ(study.model.calibrate, std::vector<std::string>{"friction"});
    EXPECT_EQ(study.model.fit_to, "dry");
    EXPECT_EQ(study.model.bridge_force, FormulaVariant::derived);
}

TEST_F(ReadStudy, TakesTheFileItselfToo) {
    folder_.write("study.toml", grains + readings);
    EXPECT_EQ(read_study(folder_.path() / "study.toml").sources.size(), 1u);
}

TEST_F(ReadStudy, KeepsTheEntriesOrderWhateverTheirKind) {
    const Study study = read(grains + cell + readings + "[[recording]]\nfile = \"dry_1.csv\"\n");
    ASSERT_EQ(study.sources.size(), 2u);
    EXPECT_EQ(study.sources[0].kind, Source::Kind::readings);
    EXPECT_EQ(study.sources[1].position.line, 10);
}

TEST_F(ReadStudy, TakesAFolderWithPatternCharactersInItsName) {
    const std::filesystem::path odd = folder_.path() / "run[1]*";
    std::filesystem::create_directories(odd);
    std::ofstream(odd / "study.toml") << grains << readings;
    std::ofstream(odd / "points.csv") << "a\n1\n";
    EXPECT_EQ(read_study(odd).sources.at(0).files.at(0), odd / "points.csv");
}

TEST_F(ReadStudy, RefusesWhatIsNotThere) {
    expect_told({input_error([&] { read_study(folder_.path() / "none"); }),
                 input_error([&] { read_study(folder_.path()); })});
}

TEST_F(ReadStudy, RefusesASyntaxErrorAtItsPlace) {
    expect_told({error("[grains]\ndiameter = 500 um\n"), error("[grains\n")});
}

TEST_F(ReadStudy, RefusesUnknownKeysAtEveryLevel) {
    expect_told({error("[grains]\ndiametre = \"1 mm\"\n"), error("[grain]\n"),
                 error(grains + "[liquid]\nangle = 3\n"), error(grains + "[cell]\nradius = 3\n"),
                 error(grains + "[[readings]]\nfiles = \"x\"\n"),
                 error(grains + "[[recording]]\nglob = \"x\"\n"),
                 error(grains + "[model]\nbse = \"dem\"\n")});
}

TEST_F(ReadStudy, RefusesMissingKeys) {
    expect_told({error(liquid), error("[grains]\ndiameter = \"1 mm\"\n" + readings),
                 error(grains + "[liquid]\ncontact_angle = \"0 deg\"\n"),
                 error(grains + "[[readings]]\nliquid_content = 0\n"), error(grains)});
}

TEST_F(ReadStudy, RefusesQuantitiesWithoutOrWithTheWrongUnit) {
    expect_told({error("[grains]\ndiameter = 500\n"), error("[grains]\ndiameter = \"500\"\n"),
                 error("[grains]\ndiameter = \"500 kg\"\n"), error("[grains]\ndiameter = true\n"),
                 error(grains + "youngs_modulus = \"3.3 Gpa\"\n"),
                 error(grains + "poisson_ratio = nan\n")});
}

TEST_F(ReadStudy, RefusesImpossibleGrainsAndLiquids) {
    std::vector<std::string> told;
    told.push_back(error("[grains]\ndiameter = \"0 mm\"\n"));
    told.push_back(error(grains + "youngs_modulus = \"-1 GPa\"\n"));
    for (const char* ratio : {"-1.0", "0.5", "3"})
        told.push_back(error(grains + "poisson_ratio = " + ratio + "\n"));
    const std::string start = grains + "[liquid]\nsurface_tension = \"20 mN/m\"\ncontact_angle = ";
    told.push_back(error(start + "\"90 deg\"\n"));
    told.push_back(error(start + "2\n"));
    told.push_back(error(start + "\"1 deg\"\nviscosity = \"-1 Pa s\"\n"));
    told.push_back(error(grains + "[liquid]\nsurface_tension = \"65 N/m\"\n"));
    expect_told(told);
}

TEST_F(ReadStudy, RefusesImpossibleCells) {
    const auto radii = [&](const std::string& inner, const std::string& outer) {
        return error(grains + "[cell]\ninner_radius = \"" + inner + "\"\nouter_radius = \"" +
                     outer + "\"\n");
    };
    expect_told({radii("45 mm", "45 mm"), radii("-1 mm", "45 mm"), radii("1 mm", "0 mm"),
                 error(grains + cell + "bead_volume = \"57 cm^3\"\n"),
                 error(grains + cell + "torque_formula = \"printed\"\n")});
}

TEST_F(ReadStudy, RefusesSourcesThatCannotBeRead) {
    expect_told({error(grains + "[[readings]]\nfile = \"wet.csv\"\n"),
                 error(grains + "[[readings]]\nfile = \"wet_*.csv\"\n"),
                 error(grains + "[readings]\nfile = \"points.csv\"\n"),
                 error(grains + readings + readings),
                 error(grains + liquid + readings + "liquid_content = -0.1\n")});
}

TEST_F(ReadStudy, RefusesRecordingsThatCannotBeReduced) {
    const std::string recording = "[[recording]]\nfile = \"dry_*.csv\"\n";
    expect_told(
        {error(grains + recording),
         error(grains + "[cell]\ninner_radius = \"0 mm\"\nouter_radius = \"45 mm\"\n" + recording),
         error(grains + cell + recording + "liquid_content = 0.03\n"),
         error(grains + liquid + cell + recording)});
}

TEST_F(ReadStudy, RefusesModelsItDoesNotHave) {
    const std::string start = grains + readings + "[model]\n";
    expect_told({error(start + "base = \"dme\"\n"), error(start + "fit_to = \"wet\"\n"),
                 error(start + "bridge_force = 3\n"),
                 error(start + "calibrate = [\"surface_tension\"]\n"),
                 error(start + "calibrate = \"friction\"\n"), error(start + "effects = [3]\n"),
                 error(start + "discrepancy = -0.01\n"),
                 error(start + "discrepancy = [0.01, 0.01, 0.01]\n")});
}

TEST_F(ReadStudy, TakesTheExpectedErrorOfTheModel) {
    const std::string start = grains + readings + "[model]\n";
    using Pair = std::array<double, 2>;
    EXPECT_EQ(read(start + "discrepancy = 0.005\n").model.discrepancy, (Pair{0.005, 0}));
    EXPECT_EQ(read(start + "discrepancy = [0.005, 0.001]\n").model.discrepancy,
              (Pair{0.005, 0.001}));
    EXPECT_EQ(read(start).model.discrepancy, usual_discrepancy);
    EXPECT_FALSE(read(start).model.discrepancy_stated);
    EXPECT_EQ(read(start + "discrepancy = 0\n").model.discrepancy, (Pair{0, 0}));
    EXPECT_TRUE(read(start + "discrepancy = 0\n").model.discrepancy_stated);
}

TEST(StudyTest, RefusesBeadsThatDoNotFitIntoTheCell) {
    const TemporaryFolder folder;
    const auto refused = [&](const std::string& diameter, const std::string& mass) {
        folder.write("study.toml", "[grains]\ndiameter = \"" + diameter +
                                       "\"\ndensity = \"2500 kg/m^3\"\n[cell]\n"
                                       "inner_radius = \"15 mm\"\nouter_radius = \"30 mm\"\n"
                                       "bead_mass = \"" +
                                       mass + "\"\n");
        return input_error([&] { read_study(folder.path()); });
    };
    // 2 g fill 0.8 cm^3 of an area of 21.2 cm^2: less than 1 mm in any packing.
    expect_told({refused("300 mm", "20 g"), refused("2 mm", "2 g"), refused("2 mm", "20 g")});
}

}  // namespace pendular::data_study_test
