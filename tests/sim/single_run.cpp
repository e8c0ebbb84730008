#include "sim/runs/single_run.h"
#include "sim/runs/run_request.h"

#include <numbers>
#include <stdexcept>

#include "tests/support/golden.h"

namespace pendular::sim_single_run_test {

ActiveEffect active(const std::string& name, double value) {
    return {&built_in_effect(name), {value}};
}

const dem::RunParameters dry{.friction = 0.2};

dem::RunParameters wet() {
    dem::RunParameters run = dry;
    run.wetting = {.reduced_pressure = 3, .bridge_volume = 2e-3};
    return run;
}

std::string refusal(const dem::RunParameters& run, const ActiveEffect& effect) {
    try {
        changed_run(run, {effect}, {});
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "accepted";
}

TEST(SingleRun, IsUnchangedWithoutEffects) {
    EXPECT_EQ(run_description(changed_run(wet(), {}, {})), run_description(wet()));
    EXPECT_EQ(run_description(changed_run(dry, {}, {})), run_description(dry));
}

TEST(SingleRun, HasEffectsOnGrainsInItsUnits) {
    // A force over a^2 s22 = (500 um)^2 1 kPa = 0.25 mN; a viscosity over sqrt(m s22/a).
    EXPECT_NEAR(changed_run(dry, {active("dry-adhesion", 5e-6)}, {}).effects[0].values[0], 0.02,
                1e-12);
    const RunScale scale;
    const double stress = 3 * std::numbers::pi * 20.6e-3 / 500e-6;  // P* pi Gamma/a
    EXPECT_NEAR(scale.of(wet()).normal_stress, stress, 1e-9 * stress);
    const double mass = 1050 * std::numbers::pi / 6 * 500e-6 * 500e-6 * 500e-6;
    const auto run =
        changed_run(wet(), {active("viscous-bridges", 0.05), active("polydispersity", 0.1)}, scale);
    ASSERT_EQ(run.effects.size(), 2u);
    EXPECT_EQ(run.effects[0].effect, "polydispersity");  // by name
    EXPECT_EQ(run.effects[0].values[0], 0.1);
    EXPECT_NEAR(run.effects[1].values[0], 0.05 / std::sqrt(mass * stress / 500e-6), 1e-12);
    EXPECT_EQ(run.wetting->reduced_pressure, 3);
}

TEST(SingleRun, HasAnotherFrictionOrLiquidAtTheSameStress) {
    EXPECT_DOUBLE_EQ(changed_run(wet(), {active("wet-friction", -0.05)}, {}).friction, 0.15);
    // F0 is proportional to Gamma cos(theta).
    EXPECT_NEAR(changed_run(wet(), {active("contact-angle", std::numbers::pi / 3)}, {})
                    .wetting->reduced_pressure,
                6, 1e-9);
    EXPECT_NEAR(
        changed_run(wet(), {active("capillary-bridges", 0.0103)}, {}).wetting->reduced_pressure, 6,
        1e-9);
    EXPECT_FALSE(changed_run(wet(), {active("capillary-bridges", 0)}, {}).wetting);
}

TEST(SingleRun, SaysWhichEffectsItCannotHave) {
    expect_told({refusal(dry, active("torque-offset", 1e-3)),
                 refusal(wet(), active("capillary-shear-stress", 1)),
                 refusal(dry, active("willett-bridges", 1)),
                 refusal(wet(), active("dry-adhesion", 1e-6))});
    EXPECT_TRUE(needs_scale(built_in_effect("dry-adhesion")));
    EXPECT_FALSE(needs_scale(built_in_effect("rolling-resistance")));
    EXPECT_FALSE(needs_scale(built_in_effect("contact-angle")));
}

}  // namespace pendular::sim_single_run_test
