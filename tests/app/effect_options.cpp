// Options --EFFECT.PARAMETER as users meet them, through `virtual-lab`.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "sim/catalogue/effect.h"
#include "sim/lab/lab_plan.h"
#include "tests/support/app_support.h"

namespace app_effect_options_test {

using pendular::TemporaryFolder;

/// One fast step, a second of work, also where a test fails and the option is taken.
const std::string one_step =
    " --fidelity quick --dry --dry-normal-stresses \"1 kPa\" --inertial-numbers 0.5 --replicates 1 "
    "--rows 200 --friction 0.4 --quiet ";

void expect_refused_options(const std::vector<std::string>& options) {
    const TemporaryFolder folder;
    std::vector<std::string> commands;
    for (const std::string& option : options)
        commands.push_back("virtual-lab " + (folder.path() / "lab").string() + one_step + option);
    expect_refused(commands);
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "lab"));
}

TEST(EffectOptions, AreThereForEveryParameterThatCanBeSimulated) {
    const Outcome help = run_pendular("virtual-lab --help");
    ASSERT_EQ(help.code, 0);
    int hidden = 0;
    for (const auto& effect : pendular::built_in_effects()) {
        const bool of_models = !pendular::why_not_in_lab(effect).empty();
        hidden += of_models ? 1 : 0;
        for (const auto& parameter : effect.parameters) {
            const std::string option = "--" + effect.name + "." + parameter.name + " ";
            EXPECT_EQ(help.output.find(option) == std::string::npos, of_models) << option;
        }
    }
    // Five approximations of the formulas, the peak strength, and five of tables.
    EXPECT_EQ(hidden, 11);
}

// An effect that acts on predictions alone is refused for the reason, not as an unknown option.
TEST(EffectOptions, SayWhyALaboratoryCannotHaveAnEffect) {
    expect_refused_options({"--peak-strength.factor 1.1", "--contact-stress.on 1"});
}

TEST(EffectOptions, RefuseWhatTheyCannotTake) {
    expect_refused_options({"--torque-ofset.torque 1", "--torque-offset.torqe=1",
                            "--torque-offset.torque 1", "--torque-offset.torque 0.1001",
                            "--torque-offset.torque nan", "--torque-offset.torque \"1 mN\"",
                            "--contact-angle.angle \"90 deg\"", "--bead-loss.fraction \"30 %\"",
                            "--grain-weight.on 0.5", "--grain-weight.on yes",
                            "--wet-friction.difference 0.1"});
}

TEST(EffectOptions, TakeNumbersWithAndWithoutTheirUnit) {
    const TemporaryFolder folder;
    const Outcome made =
        run_pendular("virtual-lab " + (folder.path() / "lab").string() + one_step +
                     "--json - --torque-offset.torque \"-0.4 mN m\" --height-offset.offset 2e-5 "
                     "--lid-slip.fraction \"10 %\" --grain-weight.on 1 --torque-gain.gain 1");
    ASSERT_EQ(made.code, 0) << made.errors;
    const auto effects = nlohmann::json::parse(made.output)["effects"];
    // At its neutral value the gain is none.
    ASSERT_EQ(effects.size(), 4u);
    EXPECT_DOUBLE_EQ(effects["torque-offset.torque"], -4e-4);
    EXPECT_DOUBLE_EQ(effects["height-offset.offset"], 2e-5);
    EXPECT_DOUBLE_EQ(effects["lid-slip.fraction"], 0.1);
    EXPECT_EQ(effects["grain-weight.on"], 1);
    expect_told({content_of(folder.path() / "lab" / "study.toml")});
}

}  // namespace app_effect_options_test
