// Energy balance of steady shear: the work done on a sample of 200 beads is what it stores and
// what it loses, part by part. Over a strain of 1 at inertial number 0.02 and stiffness number 1000
// 0.2 % of the work was missing at most, from the finite time step; an error of first order in it,
// or a part left out, is beyond 0.5 %. About 2 s.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <optional>

#include "sim/dem/shear_cell.h"

namespace energy_test {

using namespace pendular::dem;

/// Work and energies of a stretch of steady shear, in a^3 s22.
struct Account {
    double work = 0;    ///< of shear and height
    double stored = 0;  ///< change of elastic, capillary and kinetic energy
    PairEnergy lost;

    double dissipated() const {
        return lost.friction + lost.viscosity + lost.bridges + lost.unloading;
    }
    double missing() const { return work - stored - dissipated(); }
};

/// Power of the imposed flow, stresses positive in compression.
double power(const Stress& stress, double volume, const Flow& flow) {
    return -volume * (stress.s12 * flow.shear_rate + stress.s22 * flow.height_rate);
}

double stored(const ShearCell& sample) {
    return sample.energy().elastic + sample.energy().capillary + sample.kinetic_energy();
}

Account account_of(double friction, std::optional<Wetting> wetting) {
    ShearCell sample(200, {.modulus = std::pow(1000.0, 1.5), .friction = friction}, 0.02, 17,
                     wetting ? BridgeLaw(*wetting) : BridgeLaw());
    EXPECT_TRUE(sample.compress());
    while (sample.strain() < 1) {
        sample.step();
    }
    double volume = sample.cell().volume(), dt = sample.time_step();
    sample.step(EnergyAccounting::on);
    Account account;
    account.stored = -stored(sample);
    const double end = sample.strain() + 1;
    while (sample.strain() < end) {
        // The flow moves the sample from one state to the next against the mean of their stresses.
        const Flow flow = sample.flow();
        account.work += 0.5 * dt * power(sample.stress(), volume, flow);
        volume = sample.cell().volume();
        const double next = sample.time_step();
        sample.step(EnergyAccounting::on);
        account.work += 0.5 * dt * power(sample.stress(), volume, flow);
        account.lost += sample.energy();
        dt = next;
    }
    account.stored += stored(sample);
    return account;
}

/// Friction, and whether the beads are wet.
class EnergyBalance : public testing::TestWithParam<std::pair<double, bool>> {};

TEST_P(EnergyBalance, Closes) {
    const auto [friction, wet] = GetParam();
    const Account a = account_of(
        friction,
        wet ? std::optional(Wetting{.reduced_pressure = 1, .bridge_volume = 4e-3}) : std::nullopt);
    std::printf(
        "friction %.1f, %s: work %.2f = stored %.2f + sliding %.2f + viscosity %.2f + "
        "bridges %.2f + unloading %.2f, missing %.2f %%\n",
        friction, wet ? "wet" : "dry", a.work, a.stored, a.lost.friction, a.lost.viscosity,
        a.lost.bridges, a.lost.unloading, 100 * a.missing() / a.work);
    EXPECT_GT(a.work, 10);
    EXPECT_LT(std::abs(a.missing()), 0.005 * a.work);
    for (const double part : {a.lost.friction, a.lost.bridges, a.lost.unloading}) {
        EXPECT_GE(part, 0);
    }
    EXPECT_GT(a.lost.viscosity, 0.02 * a.work);
    EXPECT_EQ(a.lost.friction > 0.3 * a.work, friction > 0);
    EXPECT_EQ(a.lost.bridges > 0.1 * a.work, wet);
}

INSTANTIATE_TEST_SUITE_P(Dry, EnergyBalance,
                         testing::Values(std::pair{0.0, false}, std::pair{0.1, false},
                                         std::pair{0.3, false}));
INSTANTIATE_TEST_SUITE_P(Wet, EnergyBalance,
                         testing::Values(std::pair{0.0, true}, std::pair{0.1, true},
                                         std::pair{0.3, true}));

}  // namespace energy_test
