// Badetti et al.'s closures on simulated states: each to the accuracy Badetti et al. (2018) claims
// for it, plus three standard errors of the runs. Runs at kappa 1000 and inertial number 0.01, 1000
// beads: about 35 s of one core.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <thread>

#include "sim/closures/closure_values.h"
#include "sim/closures/state.h"
#include "sim/runs/ensemble.h"

namespace closures_test {

using namespace pendular;
using namespace pendular::closures;
using dem::Observable;

dem::RunParameters flow(std::uint64_t seed, std::optional<dem::Wetting> wetting = {}) {
    return {.friction = 0.09,
            .inertial_number = 0.01,
            .stiffness_number = 1000,
            .wetting = wetting,
            .grains = 1000,
            .strain = 4,
            .seed = seed};
}

/// A simulated state with what the closures say of it.
struct Simulated {
    dem::RunResult run;
    double dry_stress_ratio = 0, dry_error = 0;  ///< mu*_0 at the same inertial number

    double value(Observable which) const { return run[which].value; }
    double error(Observable which) const { return run[which].standard_error; }
    State state() const { return network_state_of(run); }
    CapillaryStress capillary() const { return capillary_stress_of(run); }
    double pressure() const { return state().reduced_pressure; }
    double stress_ratio() const { return value(Observable::stress_ratio); }
    /// Relative, of the ratio of a prediction from mu*_0 to the measured stress ratio.
    double noise() const {
        return std::hypot(dry_error / dry_stress_ratio,
                          error(Observable::stress_ratio) / stress_ratio());
    }
    double contact_ratio() const {
        return contact_stress_ratio(stress_ratio(), capillary(), pressure());
    }
    /// Cohesion that joins the dry and the wet stress ratio, and its error.
    double cohesion() const { return (stress_ratio() - dry_stress_ratio) * pressure(); }
    double cohesion_error() const {
        return pressure() * std::hypot(dry_error, error(Observable::stress_ratio));
    }
    double rumpf() const {
        return reduced_cohesion(dry_stress_ratio, state().solid_fraction,
                                approximate_coordination(state()));
    }
    double generalised() const {
        return generalised_cohesion(dry_stress_ratio, state().solid_fraction,
                                    effective_coordination(state()), capillary().shear);
    }
    /// Predicted over measured stress ratio, less 1.
    double strength1() const {
        return stress_ratio_from_stresses(dry_stress_ratio, capillary(), pressure()) /
                   stress_ratio() -
               1;
    }
    double strength2() const {
        return stress_ratio_from_cohesion(dry_stress_ratio, generalised(), pressure()) /
                   stress_ratio() -
               1;
    }
    double strength3() const {
        const double cohesion = reduced_cohesion(dry_stress_ratio, state().solid_fraction,
                                                 effective_coordination(state()));
        return stress_ratio_from_cohesion(dry_stress_ratio, cohesion, pressure()) / stress_ratio() -
               1;
    }
};

/// Eq. (9) takes contacts as if their centres were a apart. Overlaps make the stress smaller by
/// <F h>/<F> of the contact part, 5/3 <h> for Hertz contacts whose forces are distributed
/// exponentially; the overlaps of the capillary part and viscous forces go the other way.
void expect_mean_stress(const Simulated& s) {
    const double found = (3 + s.value(Observable::first_normal_stress_difference) -
                          s.value(Observable::second_normal_stress_difference)) /
                         3;
    const State state = s.state();
    const double contact =
        mean_stress(state) -
        (s.run.parameters.wetting ? capillary_pressure(state) / state.reduced_pressure : 0);
    const double noise = 3 * contact * s.error(Observable::contact_force) / state.contact_force;
    EXPECT_NEAR(mean_stress(state), found,
                5.0 / 3 * s.value(Observable::overlap) * contact + noise);
}

/// Exact but for overlaps, which make the stress of contacts smaller by <h>; 3e-4 for taking a
/// product of means for a mean of products.
void expect_capillary_pressure(const Simulated& s) {
    const double found = s.value(Observable::capillary_pressure) * s.pressure();
    const double high = capillary_pressure(s.state()) / found - 1;
    EXPECT_GT(high, 0);
    EXPECT_LT(high, s.value(Observable::overlap) + 3e-4);
    // Without the gaps: "negligible", 2 % of the mean stress where Badetti et al. (2018) puts a
    // number.
    const double estimate =
        capillary_pressure(s.state().solid_fraction, effective_coordination(s.state()));
    EXPECT_LT(std::abs(estimate), std::abs(capillary_pressure(s.state())));
    EXPECT_NEAR(estimate / found, 1, 0.02);
}

/// "The relative difference never exceeds 3 %."
void expect_isotropic_capillary_stress(const Simulated& s) {
    const double noise = s.error(Observable::capillary_stress_22) /
                         std::abs(s.value(Observable::capillary_stress_22));
    EXPECT_NEAR(s.capillary().normal / (s.value(Observable::capillary_pressure) * s.pressure()), 1,
                0.03 + 3 * noise);
}

/// F_d is 0.48 to 0.6 F0 and Z_d up to 3.2 in Badetti et al. (2018), so that 0.5 makes Z* at most
/// 0.1 x 3.2 of about 8 wrong: 4 %.
void expect_coordination_shortcut(const Simulated& s) {
    EXPECT_NEAR(approximate_coordination(s.state()) / effective_coordination(s.state()), 1, 0.04);
}

/// "Between 5 and 10 %" at the smallest P*, better elsewhere.
void expect_effective_stress(const Simulated& s) {
    const double claimed = s.pressure() < 1 ? 0.10 : 0.05;
    EXPECT_NEAR(s.contact_ratio() / s.dry_stress_ratio, 1, claimed + 3 * s.noise());
    // What is wrong with mu*_0 is multiplied by s22cont/s22 mu*_0/mu* in Eq. (19), 1.2 at
    // P* = 0.5; Eq. (22) takes Pcap for s22cap, 3 % of mu*_0 s22cap/s22 more.
    const double lever =
        (1 - s.capillary().normal / s.pressure()) * s.dry_stress_ratio / s.stress_ratio();
    const double allowed = lever * (claimed + 3 * s.noise());
    EXPECT_NEAR(s.strength1(), 0, allowed);
    EXPECT_NEAR(s.strength2(), s.strength1(), 0.03 * lever);
}

/// Without s12cap the strength is too high, "by 20--30 % in some cases".
void expect_strength_without_shear(const Simulated& s) {
    EXPECT_GT(s.strength3(), s.strength2());
    EXPECT_GT(s.strength3(), -3 * s.noise());
    EXPECT_LT(s.strength3(), 0.3 + 3 * s.noise());
}

/// Exact but for overlaps h. Contacts that carry much overlap more and point along the
/// compression: <h n1 n2> is about <h> (F12c + 2/3 of the force anisotropy), since h ~ F^(2/3).
void expect_contact_shear_stress(const Simulated& s) {
    const double found = s.value(Observable::capillary_shear_stress_contact) * s.pressure();
    const double anisotropy = s.value(Observable::force_anisotropy_12_contact);
    const double expected =
        s.value(Observable::overlap) * (1 + 2.0 / 3 * anisotropy / s.state().fabric_12_contact);
    const double high = contact_capillary_shear_stress(s.state()) / found - 1;
    EXPECT_GT(found, 0);
    EXPECT_NEAR(high, expected, 0.5 * expected);
}

/// "Quite accurate"; Badetti et al. (2018) has no number. At kappa 1000 and friction 0.09 it is 4
/// to 7 % too small at P* from 0.5 to 4, and the product of the anisotropies that it leaves out
/// accounts for that to 3 %.
void expect_distant_shear_stress(const Simulated& s) {
    const State state = s.state();
    const double found = s.value(Observable::capillary_shear_stress_distant) * s.pressure();
    const double closure = distant_capillary_shear_stress(state);
    EXPECT_LT(found, 0);
    EXPECT_NEAR(closure / found, 1, 0.10);
    const double bracket = state.fabric_12_distant + state.force_anisotropy_12_distant +
                           state.length_anisotropy_12_distant;
    const double lacking =
        -15 * state.fabric_12_distant * state.fabric_12_distant * state.force_anisotropy_12_distant;
    const double noise = std::hypot(s.error(Observable::fabric_12_distant),
                                    s.error(Observable::force_anisotropy_12_distant)) /
                         bracket;
    EXPECT_NEAR(closure * (1 + lacking / bracket) / found, 1, 0.03 + 3 * noise);
    // "Of relative order 1e-2": below 3 % here.
    EXPECT_LT(state.length_anisotropy_12_distant / bracket, 0.035);
    EXPECT_GT(state.length_anisotropy_12_distant, 0);
}

/// "Very good" on Badetti et al.'s scale from 0 to 0.1: within a tenth of it.
void expect_shear_stress(const Simulated& s) {
    EXPECT_NEAR(capillary_shear_stress(s.state()), s.capillary().shear, 0.01);
    EXPECT_GT(s.capillary().shear, 0);
}

void expect_closures_of_wet_state(const Simulated& s) {
    SCOPED_TRACE(testing::Message()
                 << "P* " << s.pressure() << ", V0 " << s.run.parameters.wetting->bridge_volume);
    expect_mean_stress(s);
    expect_capillary_pressure(s);
    expect_isotropic_capillary_stress(s);
    expect_coordination_shortcut(s);
    expect_effective_stress(s);
    expect_strength_without_shear(s);
    expect_contact_shear_stress(s);
    expect_distant_shear_stress(s);
    expect_shear_stress(s);
}

/// Cohesions at P* = 3, where Mohr-Coulomb holds.
void expect_cohesions(const Simulated& little, const Simulated& much) {
    // As far as effective stresses go: 5 % of the contact forces' stress ratio.
    const auto claimed = [](const Simulated& s) {
        return 0.05 * s.dry_stress_ratio * (s.pressure() - s.capillary().normal) +
               3 * s.cohesion_error();
    };
    // Rumpf: "correct" for liquid contents of 0.03 and more, here 0.063 ...
    EXPECT_GT(much.value(Observable::liquid_content), 0.05);
    EXPECT_NEAR(much.rumpf(), much.cohesion(), claimed(much));
    // ... and too high below: at 0.003 by half, which the generalised cohesion mends.
    EXPECT_LT(little.value(Observable::liquid_content), 0.005);
    EXPECT_GT(little.rumpf(), little.cohesion() + claimed(little));
    EXPECT_NEAR(little.generalised(), little.cohesion(), claimed(little));
    EXPECT_LT(std::abs(little.generalised() - little.cohesion()),
              0.5 * (little.rumpf() - little.cohesion()));
    // The liquid content moves the cohesion, and hardly Rumpf's.
    const double grows = much.cohesion() / little.cohesion() - 1;
    EXPECT_GT(grows, 0.2);
    EXPECT_LT(much.rumpf() / little.rumpf() - 1, 0.5 * grows);
    // "The error grows as the liquid content decreases."
    EXPECT_GT(little.strength3(), much.strength3() + 0.03);
    EXPECT_LT(std::abs(little.strength2()), little.strength3());
}

// One test for all, since each test is a process of its own and the runs are most of the time.
TEST(Closures, HoldInSimulatedStates) {
    const auto runs =
        run_all({flow(1), flow(2, {{.reduced_pressure = 3, .bridge_volume = 5e-4}}),
                 flow(3, {{.reduced_pressure = 3, .bridge_volume = 8e-3}}),
                 flow(4, {{.reduced_pressure = 0.5, .bridge_volume = 2e-3}})},
                {.threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()))});
    std::vector<Simulated> states;
    const Mean& dry = runs[0][Observable::stress_ratio];
    for (const dem::RunResult& run : runs) {
        ASSERT_TRUE(run.failure.empty()) << run.failure;
        ASSERT_TRUE(run.steady);
        states.push_back({run, dry.value, dry.standard_error});
    }
    expect_mean_stress(states[0]);
    for (std::size_t k = 1; k < states.size(); ++k)
        expect_closures_of_wet_state(states[k]);
    expect_cohesions(states[1], states[2]);
}

}  // namespace closures_test
