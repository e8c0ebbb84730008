// Effects of single runs as users meet them, in `simulate` and `runs`.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "sim/catalogue/effect.h"
#include "sim/runs/single_run.h"
#include "tests/support/app_support.h"

namespace app_run_effects_test {

using pendular::TemporaryFolder;
using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;
using nlohmann::json;

const std::string small_run =
    "simulate --quiet --beads 100 --stiffness-number 300 --inertial-number 0.1 --strain 1 "
    "--friction 0.2 ";

json run_json(const std::string& words) {
    const Outcome run = run_pendular(small_run + "--json - " + words);
    EXPECT_EQ(run.code, 0) << run.errors;
    json result = json::parse(run.output);
    result.erase("wall_seconds");
    result.erase("grain_steps_per_second");
    result.erase("particle_steps_per_second");
    return result;
}

TEST(RunEffects, AreOptionsOfSimulateWhereARunCanHaveThem) {
    const Outcome help = run_pendular("simulate --help");
    for (const auto& effect : pendular::built_in_effects()) {
        for (const auto& parameter : effect.parameters) {
            const std::string option = "--" + effect.name + "." + parameter.name + " ";
            const std::string why = pendular::why_not_in_run(effect);
            EXPECT_EQ(help.output.find(option) == std::string::npos, !why.empty()) << option;
            if (!why.empty()) {
                EXPECT_THAT(run_pendular("simulate " + option + "1").errors, HasSubstr(why));
            }
        }
    }
}

TEST(RunEffects, AreToldInSIWithTheScaleWhereItMatters) {
    const Outcome text = run_pendular(small_run + "--rolling-resistance.coefficient \"20 %\"");
    expect_told({without_simulated(text.output)});
    const json rolling = run_json("--rolling-resistance.coefficient 0.2");
    EXPECT_EQ(rolling["effects"], json({{"rolling-resistance.coefficient", 0.2}}));
    EXPECT_FALSE(rolling.contains("scale"));

    const json sticky = run_json("--dry-adhesion.force \"5 uN\" --normal-stress \"2 kPa\"");
    EXPECT_DOUBLE_EQ(sticky["effects"]["dry-adhesion.force"], 5e-6);
    EXPECT_DOUBLE_EQ(sticky["effects_in_run_units"]["dry-adhesion.force"], 0.01);
    EXPECT_DOUBLE_EQ(sticky["scale"]["normal_stress"], 2000);
    EXPECT_DOUBLE_EQ(sticky["scale"]["diameter"], 5e-4);
    EXPECT_FALSE(sticky["scale"].contains("surface_tension"));

    const std::string wet =
        "--reduced-pressure 2 --wet-friction.difference 0.1 --viscous-bridges.viscosity \"5 "
        "mPa.s\"";
    const json viscous = run_json(wet);
    EXPECT_DOUBLE_EQ(viscous["friction"], 0.3);
    EXPECT_NEAR(viscous["scale"]["normal_stress"], 258.9, 0.1);  // 2 pi 20.6 mN/m/500 um
    EXPECT_DOUBLE_EQ(viscous["scale"]["surface_tension"], 0.0206);
    expect_told({without_simulated(run_pendular(small_run + wet).output)});
}

TEST(RunEffects, ChangeNothingAtNeutralOrWithoutAny) {
    const json none = run_json("");
    for (const std::string key : {"effects", "effects_in_run_units", "scale"}) {
        EXPECT_FALSE(none.contains(key)) << key;
    }
    EXPECT_EQ(run_json("--rolling-resistance.coefficient 0"), none);
    EXPECT_NE(run_json("--rolling-resistance.coefficient 0.1")["stress_ratio"],
              none["stress_ratio"]);
    expect_told({without_simulated(run_pendular(small_run + "--density \"2 g/cm^3\"").output)});
}

TEST(RunEffects, RefuseWhatContradictsTheRun) {
    std::vector<std::string> commands;
    for (const std::string words :
         {"--willett-bridges.on 1", "--reduced-pressure 2 --dry-adhesion.force 1e-6",
          "--reduced-pressure 2 --normal-stress \"1 kPa\"", "--surface-tension \"20 mN/m\"",
          "--diameter 500", "--diameter \"-1 mm\"", "--density \"1 kPa\"",
          "--rolling-resistance.coefficient 0.9", "--rolling-resistance.coeficient 0.1",
          "--reduced-pressure 2 --wet-friction.difference -0.4",
          "--reduced-pressure 2 --bridge-volume 0.5 --rupture-distance.factor 2"})
        commands.push_back(small_run + words);
    expect_refused(commands);
}

TEST(RunEffects, GoWithStartsThreadsAndCheckpoints) {
    const TemporaryFolder folder;
    const std::string store = " --store " + (folder.path() / "runs.sqlite").string() + " ",
                      rolling =
                          "--rolling-resistance.coefficient 0.2 --reversible-bridges.on 1 "
                          "--reduced-pressure 4 ";
    const json cold = run_json(rolling + store);
    EXPECT_EQ(run_json(rolling + "--checkpoint " + (folder.path() / "kept").string() +
                       " --checkpoint-every 0.0001"),
              cold);
    EXPECT_EQ(run_json(rolling + "--threads 3"), run_json(rolling + "--threads 3"));
    EXPECT_TRUE(run_json(rolling + "--start nearest" + store).contains("start"));
    run_json("--polydispersity.deviation 0.2" + store);
    expect_refused({small_run + "--start 3" + store,
                    small_run + "--start 1 --polydispersity.deviation 0.1" + store});
}

TEST(RunEffects, StandInTheStoreAndItsTables) {
    const TemporaryFolder folder;
    const std::string store = " --store " + (folder.path() / "runs.sqlite").string() + " ";
    run_json(store);
    EXPECT_THAT(run_pendular("runs list" + store).output, Not(HasSubstr("effects")));
    run_json("--rolling-resistance.coefficient 0.1" + store);
    EXPECT_THAT(run_pendular("runs list" + store).output,
                HasSubstr("rolling-resistance.coefficient=0.1\n"));
    EXPECT_EQ(json_of("runs list --where \"effects IS NULL\"" + store)["runs"].size(), 1u);
    EXPECT_THAT(run_pendular("runs show 2" + store).output,
                HasSubstr("effects = rolling-resistance.coefficient=0.1"));
    expect_told({without_simulated(run_pendular("runs compare 1 2" + store).output)});
    const json shown = json::parse(run_pendular("runs show 2 --json -" + store).output);
    EXPECT_EQ(shown["runs"][0]["effects_in_run_units"]["rolling-resistance.coefficient"], 0.1);
    const std::string out = " --out " + folder.path().string();
    EXPECT_EQ(run_pendular("runs plot --x friction --y solid_fraction" + store + out).code, 0);

    const std::string table = (folder.path() / "runs.csv").string(),
                      other = " --store " + (folder.path() / "other.sqlite").string();
    EXPECT_EQ(run_pendular("runs export " + table + store).code, 0);
    expect_told({run_pendular("runs import " + table + other).output});
    const auto list = [](const std::string& where) {
        return run_pendular("runs list" + where).output;
    };
    EXPECT_EQ(list(other), list(store));
}

}  // namespace app_run_effects_test
