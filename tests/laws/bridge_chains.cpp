// A chain of grains across the periodic cell is pulled apart and pushed together: by symmetry every
// bridge has the same length, so that the cell's own stress is the force of one bridge.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "data/study/study.h"
#include "sim/dem/shear_cell.h"

namespace bridge_chains_test {

using namespace pendular;
using namespace pendular::dem;

constexpr int grains = 5;
constexpr double modulus = 3e4;

class Chain {
  public:
    explicit Chain(const Wetting& wetting)
        : cell_(row(), {.modulus = modulus, .friction = 0, .damping = 0}, Flow{},
                BridgeLaw(wetting)) {
        cell_.let_bridges_form(true);
        cell_.set_time_step_fraction(0.05);
    }
    /// Changes the chain's length at this rate until the gap between its grains is passed; calls
    /// look(gap, force) at every step, the force positive where the grains attract each other.
    template <typename Look>
    void to_gap(double end, double rate, const Look& look) {
        const double sign = end > gap() ? 1 : -1;
        cell_.set_flow({.length_rate = sign * rate});
        while (sign * (end - gap()) > 0) {
            const double here = gap();
            cell_.step();
            // The sum of force times branch over the volume is the force over the cross-section.
            look(here, -cell_.stress().s11 * cell_.cell().height * cell_.cell().width);
        }
    }

  private:
    static Sample row() {
        Sample sample{Grains(grains), {grains * 0.999, 6, 6, 0}};
        for (std::size_t i = 0; i < grains; ++i) {
            sample.grains.position(i) = {0.999 * (static_cast<double>(i) + 0.5), 3, 3};
        }
        return sample;
    }
    double gap() const { return cell_.cell().length / grains - 1; }
    ShearCell cell_;
};

/// Largest attraction when a chain in contact is pulled apart, gaps seen to 1e-6.
double largest_pull(const Wetting& wetting) {
    Chain chain(wetting);
    double largest = 0;
    chain.to_gap(1e-3, 3e-4, [&](double, double force) { largest = std::max(largest, force); });
    return largest;
}

/// F0 [1 - h/He] with (pi R/2)(He^2 - h^2) = V, R = 1/2, from the geometry of a parabolic gap.
double bridge_force(double gap, double volume) {
    return 1 - gap / std::sqrt(gap * gap + 4 * volume / std::numbers::pi);
}

TEST(WetGrains, ArePulledApartByThePullOffForceAndNoLess) {
    // A gap of 1e-6 takes 1e-6 sqrt(pi/(4 V0)) of the force away, 4e-5 at the smallest volume.
    for (const double volume : {5e-4, 8e-3}) {
        for (const double pressure : {0.5, 2.0}) {
            EXPECT_NEAR(largest_pull({pressure, volume}) * pressure, 1, 1e-4)
                << "P* " << pressure << ", V0 " << volume;
        }
    }
}

TEST(WetGrains, HoldPiTimesDiameterAndSurfaceTensionInNewtons) {
    // Between two spheres of radius R, Derjaguin: 2 pi R Gamma cos(theta), which is pi a, not half
    // of it. Forces are in units of a^2 s22.
    const GrainProperties beads{.diameter = 500e-6, .density = 1050};
    const Liquid liquid{.surface_tension = 20.6e-3, .contact_angle = 0.3};
    const double stress = 300;
    const double pressure = reduced_pressure(stress, beads, liquid);
    const double newtons =
        largest_pull({pressure, 4e-3}) * beads.diameter * beads.diameter * stress;
    const double expected = std::numbers::pi * 500e-6 * 20.6e-3 * std::cos(0.3);
    EXPECT_NEAR(newtons, expected, 2e-4 * expected);
    EXPECT_NEAR(pull_off_force(beads, liquid), expected, 1e-12 * expected);
}

TEST(WetGrains, LoseTheirBridgesAtRuptureAndFormThemAgainInContactOnly) {
    const Wetting wetting{.reduced_pressure = 2, .bridge_volume = 4e-3};
    const double rupture = std::cbrt(4e-3);
    // Fast, since bridges of equal length are in unstable balance: rounding grows as exp(5 t).
    const double rate = 0.3;
    Chain chain(wetting);
    int bridged = 0, broken = 0;
    for (int cycle = 0; cycle < 2; ++cycle) {
        chain.to_gap(1.1 * rupture, rate, [&](double gap, double force) {
            const double overlap = std::max(-gap, 0.0);
            const double expected = gap > rupture ? 0
                                                  : 0.5 * bridge_force(std::max(gap, 0.0), 4e-3) -
                                                        modulus / 3 * std::pow(overlap, 1.5);
            ASSERT_NEAR(force, expected, 1e-9) << "gap " << gap << " cycle " << cycle;
            bridged += gap > 0 && gap < rupture;
            broken += gap > rupture;
        });
        chain.to_gap(-1e-3, rate, [&](double gap, double force) {
            const double expected = gap > 0 ? 0 : 0.5 - modulus / 3 * std::pow(-gap, 1.5);
            ASSERT_NEAR(force, expected, 1e-9) << "gap " << gap << " cycle " << cycle;
        });
    }
    EXPECT_GT(bridged, 100);
    EXPECT_GT(broken, 10);
}

}  // namespace bridge_chains_test
