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
using testing::HasSubstr;

/// One fast step, a second of work, also where a test fails and the option is taken.
const std::string one_step =
    " --fidelity quick --dry --dry-normal-stresses \"1 kPa\" --inertial-numbers 0.5 --replicates 1 "
    "--rows 200 --friction 0.4 --quiet ";

void expect_refused_option(const std::string& option, const std::string& why) {
    const TemporaryFolder folder;
    expect_refused("virtual-lab " + (folder.path() / "lab").string() + one_step + option, why);
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
            const auto option = HasSubstr("--" + effect.name + "." + parameter.name + " ");
            if (of_models) {
                EXPECT_THAT(help.output, testing::Not(option));
            } else {
                EXPECT_THAT(help.output, option);
            }
        }
    }
    EXPECT_EQ(hidden, 6);  // five approximations of the formulas, and the peak strength
}

// An effect that acts on predictions alone is refused for the reason, not as an unknown option.
TEST(EffectOptions, SayWhyALaboratoryCannotHaveAnEffect) {
    for (const std::string option : {"--peak-strength.factor 1.1", "--contact-stress.on 1"}) {
        expect_refused_option(option,
                              "cannot be hidden in a virtual laboratory: it changes how "
                              "readings are predicted, not how the grains flow");
    }
}

TEST(EffectOptions, RefuseWhatTheyCannotTake) {
    expect_refused_option("--torque-ofset.torque 1",
                          "unknown effect 'torque-ofset'; did you mean 'torque-offset'?");
    expect_refused_option("--torque-offset.torqe=1", "'torqe'; did you mean 'torque'?");
    expect_refused_option("--torque-offset.torque 1", "between -100 mN m and 100 mN m");
    expect_refused_option("--torque-offset.torque nan", "is not a number");
    expect_refused_option("--torque-offset.torque \"1 mN\"", "'mN' measures");
    expect_refused_option("--bead-loss.fraction \"30 %\"", "between 0 and 0.2");
    expect_refused_option("--grain-weight.on 0.5", "a switch is 0 or 1");
    expect_refused_option("--grain-weight.on yes", "--grain-weight.on");
    expect_refused_option("--wet-friction.difference 0.1", "no wet recordings");
}

// The help text prints bounds in mN m and deg; a number without a unit is in SI units.
TEST(EffectOptions, PrintValuesInTheUnitsOfInstruments) {
    const std::string help = run_pendular("virtual-lab --help").output;
    for (const char* part :
         {"-100 to 100 mN m, no effect at 0 mN m", "-89 to 89 deg", "0 to 100 uN", "-2 to 2 mm",
          "0 to 500 mPa s", "a number without a unit is in SI"}) {
        EXPECT_THAT(std::regex_replace(help, std::regex("\\s+"), " "), HasSubstr(part));
    }
    expect_refused_option("--torque-offset.torque 0.1001", "between -100 mN m and 100 mN m");
    expect_refused_option("--contact-angle.angle \"90 deg\"", "between -89 deg and 89 deg");
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
    EXPECT_THAT(content_of(folder.path() / "lab" / "study.toml"), HasSubstr("effects = []"));
}

}  // namespace app_effect_options_test
