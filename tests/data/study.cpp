#include "data/study/study.h"

#include <numbers>

#include "tests/support/data_support.h"

namespace pendular::data_study_test {

using testing::HasSubstr;
using testing::StartsWith;

// Lines are counted in the tests below.
const std::string grains = R"([grains]
diameter = "500 um"
density = "1050 kg/m^3"
)";
const std::string liquid = R"([liquid]
surface_tension = "20.6 mN/m"
contact_angle = "5 deg"
viscosity = "50 mPa.s"
)";
const std::string cell = R"([cell]
inner_radius = "21 mm"
outer_radius = "45 mm"
bead_mass = "60 g"
)";
const std::string readings = R"([[readings]]
file = "points.csv"
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
    /// Beginning of an error at this place of the study.
    auto at(const std::string& position) const {
        return StartsWith((folder_.path() / "study.toml").string() + position);
    }

    TemporaryFolder folder_;
};

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
              (std::vector{folder_.path() / "dry_1.csv", folder_.path() / "dry_10.csv",
                           folder_.path() / "dry_2.csv"}));
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
    EXPECT_THAT(input_error([&] { read_study(folder_.path() / "none"); }),
                HasSubstr("does not exist"));
    EXPECT_THAT(input_error([&] { read_study(folder_.path()); }), HasSubstr("no study.toml"));
}

TEST_F(ReadStudy, RefusesASyntaxErrorAtItsPlace) {
    EXPECT_THAT(error("[grains]\ndiameter = 500 um\n"), at(":2:16: "));
    EXPECT_THAT(error("[grains\n"), at(":1:"));
}

TEST_F(ReadStudy, RefusesUnknownKeysAtEveryLevel) {
    EXPECT_THAT(error("[grains]\ndiametre = \"1 mm\"\n"),
                at(":2:1: unknown key 'diametre' in [grains]; did you mean 'diameter'?"));
    EXPECT_THAT(error("[grain]\n"), at(":1:2: unknown key 'grain'; did you mean 'grains'?"));
    EXPECT_THAT(error(grains + "[liquid]\nangle = 3\n"), at(":5:1: unknown key 'angle'"));
    EXPECT_THAT(error(grains + "[cell]\nradius = 3\n"), at(":5:1: unknown key 'radius'"));
    EXPECT_THAT(error(grains + "[[readings]]\nfiles = \"x\"\n"),
                at(":5:1: unknown key 'files' in [[readings]]; did you mean 'file'?"));
    EXPECT_THAT(error(grains + "[[recording]]\nglob = \"x\"\n"), at(":5:1: unknown key 'glob'"));
    EXPECT_THAT(error(grains + "[model]\nbse = \"dem\"\n"),
                at(":5:1: unknown key 'bse' in [model]; did you mean 'base'?"));
}

TEST_F(ReadStudy, RefusesMissingKeys) {
    EXPECT_THAT(error(liquid), HasSubstr("[grains] is missing"));
    EXPECT_THAT(error("[grains]\ndiameter = \"1 mm\"\n" + readings),
                at(":1:1: [grains] lacks 'density'; add density = \"... kg/m^3\""));
    EXPECT_THAT(error(grains + "[liquid]\ncontact_angle = \"0 deg\"\n"),
                at(":4:1: [liquid] lacks 'surface_tension'"));
    EXPECT_THAT(error(grains + "[[readings]]\nliquid_content = 0\n"), at(":4:1: lacks 'file'"));
    EXPECT_THAT(error(grains), HasSubstr("nothing was measured"));
}

TEST_F(ReadStudy, RefusesQuantitiesWithoutOrWithTheWrongUnit) {
    EXPECT_THAT(error("[grains]\ndiameter = 500\n"),
                at(":2:12: 'diameter': has no unit; write \"500 m\", \"500 mm\" or another unit"));
    EXPECT_THAT(error("[grains]\ndiameter = \"500\"\n"), at(":2:12: 'diameter': "));
    EXPECT_THAT(error("[grains]\ndiameter = \"500 kg\"\n"),
                AllOf(at(":2:12: 'diameter': "), HasSubstr("measures kg, not m")));
    EXPECT_THAT(error("[grains]\ndiameter = true\n"),
                AllOf(at(":2:12: 'diameter': "), HasSubstr("quantity")));
    EXPECT_THAT(error(grains + "youngs_modulus = \"3.3 Gpa\"\n"),
                AllOf(at(":4:18: 'youngs_modulus': "), HasSubstr("'GPa'")));
    EXPECT_THAT(error(grains + "poisson_ratio = nan\n"), AllOf(at(":4:17: "), HasSubstr("finite")));
}

TEST_F(ReadStudy, RefusesImpossibleGrainsAndLiquids) {
    EXPECT_THAT(error("[grains]\ndiameter = \"0 mm\"\n"),
                at(":2:12: 'diameter': must be positive"));
    EXPECT_THAT(error(grains + "youngs_modulus = \"-1 GPa\"\n"), at(":4:18: 'youngs_modulus'"));
    for (const char* ratio : {"-1.0", "0.5", "3"})
        EXPECT_THAT(error(grains + "poisson_ratio = " + ratio + "\n"),
                    at(":4:17: 'poisson_ratio': must lie between -1 and 0.5"));
    const std::string start = grains + "[liquid]\nsurface_tension = \"20 mN/m\"\ncontact_angle = ";
    EXPECT_THAT(error(start + "\"90 deg\"\n"), at(":6:17: 'contact_angle': must lie between"));
    EXPECT_THAT(error(start + "2\n"), at(":6:17: 'contact_angle': has no unit"));
    EXPECT_THAT(error(start + "\"1 deg\"\nviscosity = \"-1 Pa s\"\n"), at(":7:13: 'viscosity'"));
}

TEST_F(ReadStudy, RefusesImpossibleCells) {
    const auto radii = [&](const std::string& inner, const std::string& outer) {
        return error(grains + "[cell]\ninner_radius = \"" + inner + "\"\nouter_radius = \"" +
                     outer + "\"\n");
    };
    EXPECT_THAT(radii("45 mm", "45 mm"), at(":5:16: 'inner_radius': must be smaller than"));
    EXPECT_THAT(radii("-1 mm", "45 mm"), at(":5:16: 'inner_radius': must not be negative"));
    EXPECT_THAT(radii("1 mm", "0 mm"), at(":6:16: 'outer_radius': must be positive"));
    EXPECT_THAT(error(grains + cell + "bead_volume = \"57 cm^3\"\n"),
                at(":8:15: 'bead_volume': 'bead_mass' is given too; remove one"));
    EXPECT_THAT(error(grains + cell + "torque_formula = \"printed\"\n"),
                at(":8:18: 'torque_formula': unknown \"printed\"; "));
}

TEST_F(ReadStudy, RefusesSourcesThatCannotBeRead) {
    EXPECT_THAT(error(grains + "[[readings]]\nfile = \"wet.csv\"\n"),
                at(":5:8: 'file': no file matches \"wet.csv\" in "));
    EXPECT_THAT(error(grains + "[[readings]]\nfile = \"wet_*.csv\"\n"),
                AllOf(at(":5:8: 'file': no file matches \"wet_*.csv\" in "),
                      HasSubstr("put the file there")));
    EXPECT_THAT(error(grains + "[readings]\nfile = \"points.csv\"\n"),
                AllOf(at(":4:"), HasSubstr("write [[readings]]")));
    EXPECT_THAT(error(grains + readings + readings),
                AllOf(at(":6:1: 'file': points.csv was already matched by the entry of line 4")));
    EXPECT_THAT(error(grains + liquid + readings + "liquid_content = -0.1\n"),
                AllOf(at(":10:18: "), HasSubstr("negative")));
}

TEST_F(ReadStudy, RefusesRecordingsThatCannotBeReduced) {
    const std::string recording = "[[recording]]\nfile = \"dry_*.csv\"\n";
    EXPECT_THAT(error(grains + recording), at(":4:1: recordings need [cell]"));
    EXPECT_THAT(
        error(grains + "[cell]\ninner_radius = \"0 mm\"\nouter_radius = \"45 mm\"\n" + recording),
        at(":7:1: 'bead_mass' is given neither here nor in [cell]"));
    EXPECT_THAT(error(grains + cell + recording + "liquid_content = 0.03\n"),
                AllOf(at(":10:18: 'liquid_content': "), HasSubstr("no [liquid]")));
    EXPECT_THAT(error(grains + liquid + cell + recording), at(":12:1: lacks 'liquid_content'"));
}

TEST_F(ReadStudy, RefusesModelsItDoesNotHave) {
    const std::string start = grains + readings + "[model]\n";
    EXPECT_THAT(error(start + "base = \"dme\"\n"),
                at(":7:8: 'base': unknown \"dme\"; did you mean 'dem'?"));
    EXPECT_THAT(error(start + "fit_to = \"wet\"\n"), at(":7:10: 'fit_to': unknown \"wet\""));
    EXPECT_THAT(error(start + "bridge_force = 3\n"), at(":7:16: 'bridge_force': must be a string"));
    EXPECT_THAT(error(start + "calibrate = [\"surface_tension\"]\n"),
                AllOf(at(":7:13: 'calibrate': "), HasSubstr("friction")));
    EXPECT_THAT(error(start + "calibrate = \"friction\"\n"),
                AllOf(at(":7:13: 'calibrate': "), HasSubstr("list")));
    EXPECT_THAT(error(start + "effects = [3]\n"), at(":7:12: must be a name"));
    EXPECT_THAT(error(start + "discrepancy = -0.01\n"),
                AllOf(at(":7:15: 'discrepancy': "), HasSubstr("between 0 and 0.2")));
    EXPECT_THAT(error(start + "discrepancy = [0.01, 0.01, 0.01]\n"),
                AllOf(at(":7:15: 'discrepancy': "), HasSubstr("one number")));
}

TEST_F(ReadStudy, TakesTheExpectedErrorOfTheModel) {
    const std::string start = grains + readings + "[model]\n";
    using Pair = std::array<double, 2>;
    EXPECT_EQ(read(start + "discrepancy = 0.005\n").model.discrepancy, (Pair{0.005, 0}));
    EXPECT_EQ(read(start + "discrepancy = [0.005, 0.001]\n").model.discrepancy,
              (Pair{0.005, 0.001}));
    EXPECT_EQ(read(start).model.discrepancy, (Pair{0, 0}));
}

TEST(StudyTest, RefusesBeadsThatDoNotFitIntoTheCell) {
    const TemporaryFolder folder;
    const auto refused = [&](const std::string& diameter, const std::string& mass) {
        folder.write("study.toml", "[grains]\ndiameter = \"" + diameter +
                                       "\"\ndensity = \"2500 kg/m^3\"\n[cell]\n"
                                       "inner_radius = \"15 mm\"\nouter_radius = \"30 mm\"\n"
                                       "bead_mass = \"" +
                                       mass + "\"\n");
        try {
            read_study(folder.path());
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_THAT(refused("300 mm", "20 g"),
                testing::AllOf(HasSubstr("study.toml:2:"), HasSubstr("300 mm"),
                               HasSubstr("the walls of the cell, 15 mm")));
    // 2 g fill 0.8 cm^3 of an area of 21.2 cm^2: less than 1 mm in any packing.
    EXPECT_THAT(refused("2 mm", "2 g"), HasSubstr("height of the filling"));
    EXPECT_THAT(refused("2 mm", "20 g"), HasSubstr("nothing was measured"));  // and no more
}

}  // namespace pendular::data_study_test
