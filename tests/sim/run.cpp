#include <gtest/gtest.h>

#include <cmath>
#include <thread>

#include "sim/dem/run.h"
#include "sim/dem/shear_cell.h"
#include "sim/runs/ensemble.h"
#include "sim/runs/run_request.h"

namespace sim_run_test {

using namespace pendular;
using namespace pendular::dem;

/// A small, fast and soft sample: enough to see behaviour, not to measure.
RunParameters small_run() {
    return {.friction = 0.2,
            .inertial_number = 0.05,
            .stiffness_number = 300,
            .grains = 150,
            .strain = 1.5,
            .seed = 3};
}

double of(const RunResult& run, Observable which) {
    return run[which].value;
}

TEST(Run, IsTheSameForTheSameSeedAndAnotherForAnother) {
    const RunResult a = simulate(small_run()), b = simulate(small_run());
    EXPECT_EQ(of(a, Observable::stress_ratio), of(b, Observable::stress_ratio));
    EXPECT_EQ(of(a, Observable::solid_fraction), of(b, Observable::solid_fraction));
    EXPECT_EQ(a.steps, b.steps);
    RunParameters other = small_run();
    other.seed = 4;
    EXPECT_NE(of(a, Observable::stress_ratio), of(simulate(other), Observable::stress_ratio));
}

TEST(Run, HoldsItsNormalStressAndAveragesWhatWasAskedFor) {
    const RunResult r = simulate(small_run());
    EXPECT_NEAR(of(r, Observable::held_normal_stress), 1, 0.01);
    EXPECT_GE(r.strain_averaged, 1.5 - 1e-9);
    EXPECT_GT(r[Observable::stress_ratio].standard_error, 0);
    EXPECT_GT(r[Observable::solid_fraction].standard_error, 0);
    EXPECT_TRUE(r.steady);
    EXPECT_LT(of(r, Observable::fabric_12_contact),
              0);  // contacts point into the compression quadrants
}

TEST(Run, IsStrongerAndLooserWithMoreFriction) {
    RunParameters smooth = small_run(), rough = small_run();
    smooth.friction = 0.02, rough.friction = 0.6;
    const RunResult a = simulate(smooth), b = simulate(rough);
    EXPECT_GT(of(b, Observable::stress_ratio), of(a, Observable::stress_ratio) + 0.1);
    EXPECT_LT(of(b, Observable::solid_fraction), of(a, Observable::solid_fraction) - 0.015);
    EXPECT_LT(of(b, Observable::contact_coordination),
              of(a, Observable::contact_coordination) - 0.5);
}

TEST(Run, NamesTheParameterThatIsOutOfRange) {
    const auto complaint = [](RunParameters p) -> std::string {
        try {
            simulate(p);
        } catch (const std::invalid_argument& error) {
            return error.what();
        }
        return "";
    };
    const auto with = [](auto change) {
        RunParameters p = small_run();
        change(p);
        return p;
    };
    EXPECT_NE(complaint(with([](auto& p) { p.friction = -0.1; })).find("friction"),
              std::string::npos);
    EXPECT_NE(complaint(with([](auto& p) { p.grains = 63; })).find("grains"), std::string::npos);
    EXPECT_NE(complaint(with([](auto& p) { p.inertial_number = 2; })).find("inertial number"),
              std::string::npos);
    EXPECT_NE(complaint(with([](auto& p) { p.stiffness_number = 1; })).find("stiffness"),
              std::string::npos);
    EXPECT_NE(complaint(with([](auto& p) { p.strain = 0.1; })).find("strain"), std::string::npos);
    EXPECT_NE(complaint(with([](auto& p) { p.friction = std::nan(""); })).find("friction"),
              std::string::npos);
}

TEST(Run, StopsAveragingWhereItIsPreciseEnough) {
    RunParameters p = small_run();
    p.grains = 300;
    p.friction = 0.3;
    p.inertial_number = 0.1;
    p.strain = 60;
    p.precision = {{Observable::stress_ratio, 0.02}};
    const RunResult rough = simulate(p);
    EXPECT_TRUE(rough.precise);
    EXPECT_LT(rough.strain_averaged, 15);
    EXPECT_GE(rough.strain_averaged, shortest_precise_strain - 0.01);
    EXPECT_LE(rough[Observable::stress_ratio].standard_error, 0.02);
    p.precision[0].standard_error = 0.004;
    const RunResult fine = simulate(p);
    EXPECT_GT(fine.strain_averaged, 1.5 * rough.strain_averaged);
    EXPECT_LE(fine[Observable::stress_ratio].standard_error, 0.004);
    p.strain = 3;
    p.precision[0].standard_error = 1e-6;
    const RunResult never = simulate(p);
    EXPECT_FALSE(never.precise);
    EXPECT_GE(never.strain_averaged, 2.9);
}

TEST(Run, StopsWhenAskedTo) {
    std::stop_source stop;
    RunParameters endless = small_run();
    endless.strain = 1000;
    std::jthread later([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        stop.request_stop();
    });
    EXPECT_THROW(simulate(endless, {.stop = stop.get_token()}), Interrupted);
}

TEST(Run, SeesASampleCrystallise) {
    // Eighty frictionless grains order into a crystal within a strain of some tens.
    RunParameters p = small_run();
    p.grains = 80;
    p.friction = 0;
    p.stiffness_number = 100;
    p.strain = 40;
    const RunResult r = simulate(p);
    EXPECT_TRUE(r.crystallised);
    EXPECT_GT(of(r, Observable::bond_order), 0.3);
    EXPECT_FALSE(simulate(small_run()).crystallised);
}

TEST(Run, StartsFromTheStateOfAnotherAndFindsTheSame) {
    for (const bool wet : {false, true}) {
        RunParameters p = small_run();
        p.grains = 300;
        if (wet) {
            p.wetting = {.reduced_pressure = 2, .bridge_volume = 2e-3};
        }
        p.strain = 8;
        const RunResult cold = simulate(p);
        RunParameters before = p;
        before.friction = p.friction + 0.1;
        before.strain = 0.5;
        const RunResult other = simulate(before);
        p.start = fingerprint(run_description(before));
        EXPECT_THROW(simulate(p), std::invalid_argument);
        const RunResult warm = simulate(p, {.start = &other.final_state});
        EXPECT_TRUE(warm.steady);
        EXPECT_LT(warm.steps, cold.steps);
        for (const Observable which : {Observable::stress_ratio, Observable::solid_fraction,
                                       Observable::contact_coordination}) {
            // One in 2000 beyond 3.5 standard errors.
            EXPECT_NEAR(warm[which].value, cold[which].value,
                        3.5 * std::hypot(warm[which].standard_error, cold[which].standard_error));
        }
        p.grains = 200;
        EXPECT_THROW(simulate(p, {.start = &other.final_state}), std::invalid_argument);
    }
}

TEST(ShearCell, SaysWhenItsStateBlowsUp) {
    ShearCell sample(100, {.modulus = 5e3, .friction = 0.3}, 0.05, 1);
    sample.set_time_step_fraction(3);  // far beyond what the explicit integrator can follow
    try {
        sample.compress();
        for (int step = 0; step < 5000; ++step) {
            sample.step();
        }
        FAIL() << "s22 = " << sample.stress().s22;
    } catch (const SimulationError& error) {
        EXPECT_NE(std::string(error.what()).find("blew up"), std::string::npos) << error.what();
    }
}

TEST(ShearCell, HoldsSoftWetBeadsWithoutFlipping) {
    // Viscous contacts answer the height rate at once; a servo that does not reckon with it jumps
    // between s22 of about -2 and 3 from one step to the next, which no average of s22 shows.
    ShearCell sample(150, {.modulus = std::pow(300, 1.5), .friction = 0.09}, 0.05, 3,
                     BridgeLaw({.reduced_pressure = 2, .bridge_volume = 4e-3}));
    ASSERT_TRUE(sample.compress());
    double jumps = 0;
    constexpr int steps = 4000;
    for (int step = 0; step < steps; ++step) {
        const double before = sample.stress().s22;
        sample.step();
        jumps += std::abs(sample.stress().s22 - before) / steps;
    }
    EXPECT_LT(jumps, 0.1);
}

TEST(ShearCell, FollowsItsDampingWithTheTimeStep) {
    // Ten times critical damping needs ten times shorter steps, not another setting.
    RunParameters p = small_run();
    p.damping = 10;
    EXPECT_TRUE(std::isfinite(of(simulate(p), Observable::stress_ratio)));
}

TEST(ShearCell, HoldsBeadsWithAViscousLiquid) {
    // So much viscosity that a servo which took the contacts alone for damped would flip between
    // two rates, ever wider, until the sample blows up.
    RunParameters p = small_run();
    p.stiffness_number = 300;
    p.grains = 100;
    p.strain = 1;
    p.inertial_number = 0.1;
    p.wetting = {.reduced_pressure = 2, .bridge_volume = 2e-3};
    for (const double viscosity : {0.3, 2.5}) {
        p.effects = {{"viscous-bridges", {viscosity}}};
        const Mean held = simulate(p)[Observable::held_normal_stress];
        EXPECT_NEAR(held.value, 1, 0.05 + 4 * held.standard_error) << viscosity;
    }
}

TEST(ShearCell, KeepsItsMomentum) {
    ShearCell sample(150, {.modulus = 5e3, .friction = 0.3}, 0.05, 9);
    ASSERT_TRUE(sample.compress());
    for (int step = 0; step < 1000; ++step) {
        sample.step();
    }
    double px = 0, py = 0, pz = 0;
    for (std::size_t i = 0; i < sample.grains().size(); ++i) {
        px += sample.grains().velocity(i)[0], py += sample.grains().velocity(i)[1],
            pz += sample.grains().velocity(i)[2];
    }
    EXPECT_NEAR(px, 0, 1e-9);
    EXPECT_NEAR(py, 0, 1e-9);
    EXPECT_NEAR(pz, 0, 1e-9);
}

TEST(ShearCell, SaysWhenItsStressIsNeverReached) {
    // So soft that even grains pressed to a solid fraction of 0.8 do not carry the imposed stress.
    ShearCell sample(100, {.modulus = 0.5}, 0.05, 1);
    EXPECT_FALSE(sample.compress());
    EXPECT_LT(sample.stress().s22, 1);
}

TEST(ShearCell, StartsAtRandomWithoutContact) {
    const ShearCell a(500, {.modulus = 3e4}, 0.01, 1), b(500, {.modulus = 3e4}, 0.01, 2);
    EXPECT_NEAR(a.solid_fraction(), 0.3, 1e-12);
    EXPECT_EQ(find_pairs_by_brute_force(a.grains(), a.cell(), 0.0).size(), 0u);
    EXPECT_NE(a.grains().position(0), b.grains().position(0));
}

TEST(Ensemble, GivesTheSameWhateverTheNumberOfThreads) {
    std::vector<RunParameters> runs;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        runs.push_back(small_run());
        runs.back().seed = seed;
        runs.back().grains = 100 + static_cast<int>(seed) * 10;
    }
    std::size_t reports = 0;
    double last = 0;
    const auto one = run_all(runs, {.threads = 1});
    const auto three = run_all(runs, {.threads = 3, .report = [&](const EnsembleProgress& p) {
                                          ++reports;
                                          EXPECT_GE(p.fraction, last - 1e-12);
                                          last = p.fraction;
                                      }});
    ASSERT_EQ(one.size(), 5u);
    for (std::size_t k = 0; k < runs.size(); ++k) {
        EXPECT_EQ(one[k].parameters.seed, runs[k].seed);
        EXPECT_EQ(of(one[k], Observable::stress_ratio), of(three[k], Observable::stress_ratio));
    }
    EXPECT_GT(reports, 10u);
    EXPECT_NEAR(last, 1, 1e-9);
}

TEST(Ensemble, PassesOnTheFirstFailure) {
    std::vector<RunParameters> runs(3, small_run());
    runs[1].friction = -1;
    EXPECT_THROW(run_all(runs, {.threads = 2}), std::invalid_argument);
}

}  // namespace sim_run_test
