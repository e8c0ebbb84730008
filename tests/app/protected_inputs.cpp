// No command writes onto what its study is read from.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/app_support.h"

namespace app_protected_inputs_test {

using pendular::TemporaryFolder;
namespace fs = std::filesystem;

const std::string points =
    "normal_stress [Pa],stress_ratio,solid_fraction,inertial_number\n1000,0.25,0.61,0.003\n"
    "3000,0.26,0.61,0.003\n";

/// A study whose one input has that name.
class ProtectedInputs : public testing::Test {
  protected:
    std::string study(const std::string& input) {
        fs::create_directories((folder_.path() / input).parent_path());
        folder_.write(input, points);
        folder_.write("study.toml",
                      pendular::grains_table + "[[readings]]\nfile = \"" + input + "\"\n");
        return folder_.path().string();
    }
    void expect_intact(const std::string& input) {
        EXPECT_EQ(content_of(folder_.path() / input), points);
    }
    TemporaryFolder folder_;
};

TEST_F(ProtectedInputs, AreNotReplacedByImport) {
    const std::string path = study("readings.csv");
    const Outcome run = run_pendular("import " + path + " --out " + path);
    EXPECT_EQ(run.code, 2);
    expect_told({run.errors});
    expect_intact("readings.csv");
    EXPECT_FALSE(fs::exists(folder_.path() / "excluded.csv"));
    EXPECT_EQ(run_pendular("import " + path).code, 0);  // to out/
    expect_intact("readings.csv");
}

TEST_F(ProtectedInputs, InTheUsualFolderForResultsAreNotReplacedEither) {
    expect_refused({"import " + study("out/readings.csv")});
    expect_intact("out/readings.csv");
}

TEST_F(ProtectedInputs, AreKnownBehindLinks) {
    const std::string path = study("points.csv");
    const TemporaryFolder out;
    fs::create_symlink(folder_.path() / "points.csv", out.path() / "readings.csv");
    expect_refused({"import " + path + " --out " + out.path().string()});
    expect_intact("points.csv");
    fs::create_directory_symlink(folder_.path(), out.path() / "link");
    study("excluded.csv");
    expect_refused({"import " + path + " --out " + (out.path() / "link").string()});
    expect_intact("excluded.csv");
}

TEST_F(ProtectedInputs, AreNotReplacedByFitsAndDiagnoses) {
    for (const auto& [command, output] : {std::pair{"calibrate", "fit.json"},
                                          {"compare", "compare.json"},
                                          {"diagnose", "diagnosis.json"},
                                          {"next", "next.json"},
                                          {"compare", "figures/a.csv"}}) {
        const std::string path = study(output);
        expect_refused({std::string(command) + " " + path + " --quiet --out " + path});
        expect_intact(output);
    }
    const std::string path = study("ladder.json");
    expect_refused({"add " + path + " torque-offset --quiet --out " + path});
}

TEST_F(ProtectedInputs, AreNotReplacedByJson) {
    const std::string path = study("points.csv"), file = path + "/points.csv";
    expect_refused({"import " + path + " --json " + file,
                    "effects --study " + path + " --json " + file,
                    "import " + path + " --json " + path + "/study.toml",
                    "import " + path + "/study.toml --json " + path + "/study.toml"});
    expect_intact("points.csv");
}

TEST_F(ProtectedInputs, DoNotGrowByWhatACommandWrites) {
    study("points.csv");
    folder_.write("study.toml", pendular::grains_table + "[[readings]]\nfile = \"*.csv\"\n");
    const std::string path = folder_.path().string();
    expect_refused({"import " + path + " --out " + path});
    EXPECT_FALSE(fs::exists(folder_.path() / "readings.csv"));
    EXPECT_EQ(run_pendular("import " + path).code, 0);  // out/readings.csv is no match
    EXPECT_EQ(run_pendular("import " + path).code, 0);
}

TEST_F(ProtectedInputs, DoNotKeepOtherCommandsFromTheirFolder) {
    // What an earlier import wrote may be an input of later commands that do not write it.
    const std::string path = study("out/readings.csv");
    expect_told({run_pendular("compare " + path).errors});
}

}  // namespace app_protected_inputs_test
