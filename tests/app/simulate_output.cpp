// What a run yields besides its averages: dissipation, profiles, distributions, checkpoints.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cmath>
#include <csignal>
#include <fstream>
#include <numbers>

#include "data/input_error.h"
#include "sim/dem/checkpoint.h"
#include "sim/dem/fields.h"
#include "sim/dem/run.h"
#include "sim/dem/shear_cell.h"
#include "sim/runs/run_request.h"
#include "tests/support/app_support.h"

namespace sim_output_test {

using namespace pendular;
using namespace pendular::dem;

RunParameters small_run() {
    return {.friction = 0.2,
            .inertial_number = 0.05,
            .stiffness_number = 300,
            .grains = 150,
            .strain = 2,
            .seed = 3};
}

RunParameters small_wet_run() {
    RunParameters p = small_run();
    p.wetting = Wetting{.reduced_pressure = 2, .bridge_volume = 4e-3};
    return p;
}

double value(const RunResult& run, Observable which) {
    return run[which].value;
}

/// Sum over the bins of a density times their width: the part of all that the bins hold.
double integral(const BinnedMeans& field, double width) {
    double sum = 0;
    for (const Mean& mean : field.means) {
        sum += mean.value * width;
    }
    return sum;
}

void expect_same(const std::vector<Mean>& a, const std::vector<Mean>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t k = 0; k < a.size(); ++k) {
        if (!std::isnan(a[k].value) || !std::isnan(b[k].value)) {
            EXPECT_EQ(a[k].value, b[k].value);
            EXPECT_EQ(a[k].standard_error, b[k].standard_error);
        }
    }
}

void expect_same(const RunResult& a, const RunResult& b) {
    expect_same({a.means.begin(), a.means.end()}, {b.means.begin(), b.means.end()});
    for (std::size_t k = 0; k < field_count; ++k) {
        expect_same(a.fields[k].means, b.fields[k].means);
    }
    EXPECT_EQ(a.covariance, b.covariance);
    EXPECT_EQ(a.steps, b.steps);
    EXPECT_EQ(a.time_step, b.time_step);
    EXPECT_EQ(a.strain_averaged, b.strain_averaged);
    EXPECT_EQ(a.strain_transient, b.strain_transient);
    EXPECT_EQ(a.steady, b.steady);
}

/// Interrupts a run at several strains and takes it up again each time.
RunResult in_pieces(const RunParameters& p, const std::filesystem::path& file, int threads = 1) {
    for (const double until : {0.0, 0.31, 1.5}) {
        Checkpoint checkpoint(file);
        std::stop_source stop;
        const Observer stop_there = [&](const ShearCell&, double strain) {
            if (strain >= until) {
                stop.request_stop();
            }
        };
        if (until == 0) {
            stop.request_stop();  // while the random gas is being compressed
        }
        EXPECT_THROW(simulate(p, {.stop = stop.get_token(),
                                  .threads = threads,
                                  .observers = {stop_there},
                                  .checkpoint = &checkpoint}),
                     Interrupted);
        EXPECT_TRUE(checkpoint.exists());
    }
    Checkpoint checkpoint(file);
    return simulate(p, {.threads = threads, .checkpoint = &checkpoint});
}

/// Error message of resuming a run from this file.
std::string complaint(const RunParameters& p, const std::filesystem::path& file, int threads = 1) {
    const std::string before = content_of(file);
    try {
        Checkpoint checkpoint(file);
        simulate(p, {.threads = threads, .checkpoint = &checkpoint});
    } catch (const InputError& error) {
        EXPECT_EQ(content_of(file), before);  // left alone
        return error.what();
    }
    return "";
}

/// A run of these parameters put down as soon as it flows.
void put_down(const RunParameters& p, const std::filesystem::path& file) {
    Checkpoint checkpoint(file);
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(simulate(p, {.stop = stop.get_token(), .checkpoint = &checkpoint}), Interrupted);
}

TEST(Dissipation, AddsUpToTheStressRatio) {
    // In a steady state all work of the shear stress is lost: s12 rate V = power lost. Both sides
    // fluctuate together, so that their difference is far less than their errors: 2 % for energies
    // of one step, accurate to the order of the time step, and for what the cell still stores. That
    // bridges form is rare and only one step in 16 is looked at: that part keeps its error.
    for (RunParameters p : {small_run(), small_wet_run()}) {
        p.strain = 6;
        p.stiffness_number = 1000;
        const RunResult r = simulate(p);
        double sum = 0;
        for (const Observable which :
             {Observable::dissipation_friction, Observable::dissipation_viscosity,
              Observable::dissipation_bridges, Observable::dissipation_springs}) {
            EXPECT_GE(value(r, which), 0);
            sum += value(r, which);
        }
        const double ratio = value(r, Observable::stress_ratio),
                     sampling = r[Observable::dissipation_bridges].standard_error;
        EXPECT_NEAR(sum, ratio, 0.02 * ratio + 3 * sampling);
        EXPECT_LT(sampling, 0.02 * ratio);
        EXPECT_GT(value(r, Observable::dissipation_springs), 0);
        EXPECT_EQ(value(r, Observable::dissipation_bridges) > 0, p.wetting.has_value());
    }
}

TEST(Profiles, CutSpheresAtTheFacesOfTheBins) {
    // One bead centred on the face at x2 = 0 of a cell of 4 x 4 x 4: half of it in the first bin,
    // half across the periodic face in the last. Another at 1.7 in bins of height 1: of a sphere of
    // diameter 1, the cap above its centre plus 0.3, depth 0.2, has pi d^2 (1/2 - d/3).
    Grains grains(2);
    grains.position(0) = {1, 0, 1};
    grains.position(1) = {3, 1.7, 3};
    BinnedSums sums(4);
    add_solid_fraction(grains, {4, 4, 4, 0}, sums);
    const double bead = std::numbers::pi / 6, cap = std::numbers::pi * 0.2 * 0.2 * (0.5 - 0.2 / 3);
    const double expected[] = {bead / 2, bead - cap, cap, bead / 2};
    for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_NEAR(sums.sum[k], expected[k], 1e-14);
        EXPECT_DOUBLE_EQ(sums.weight[k], 16);
    }
}

TEST(Profiles, OfMotionAreThoseOfThePlantedOne) {
    // Two beads in the lower bin, peculiar velocities +-d about (b, 0, 0): its mean is b, its
    // temperature d^2 in direction 2 alone, d^2/3 per component, all over (rate)^2.
    const double height = 2, rate = 0.1, b = 0.03, d = 0.06;
    Grains grains(3);
    grains.position(0) = {0, 0.2, 0}, grains.velocity(0) = {b, d, 0};
    grains.position(1) = {0, 0.6 + height, 0}, grains.velocity(1) = {b, -d, 0};
    grains.position(2) = {0, 1.5, 0};
    MotionProfile profile(2);
    profile.add(grains, height);
    const BinnedSums v = profile.velocity(height, rate), t = profile.temperature(rate);
    EXPECT_NEAR(v.sum[0] / v.weight[0], 0.25 + b / (rate * height), 1e-14);
    EXPECT_NEAR(v.sum[1] / v.weight[1], 0.75, 1e-14);
    EXPECT_NEAR(t.sum[0] / t.weight[0], d * d / 3 / (rate * rate), 1e-14);
    EXPECT_NEAR(t.sum[1], 0, 1e-14);
}

TEST(Fields, OfARunAreNormalisedAndAgreeWithItsAverages) {
    const RunResult r = simulate(small_wet_run());
    const double per_radian = std::numbers::pi / 36;
    EXPECT_NEAR(integral(r[Field::contact_orientation], per_radian), 1, 1e-12);
    EXPECT_NEAR(integral(r[Field::distant_orientation], per_radian), 1, 1e-12);
    EXPECT_NEAR(integral(r[Field::contact_force], 0.2), 1, 0.01);  // few beyond 8 times the mean
    EXPECT_NEAR(integral(r[Field::distant_gap], std::cbrt(4e-3) / 30), 1, 1e-12);
    double first_moment = 0, solid = 0;
    const BinnedMeans& forces = r[Field::contact_force];
    for (std::size_t k = 0; k < forces.at.size(); ++k) {
        first_moment += forces.at[k] * forces.means[k].value * 0.2;
    }
    EXPECT_NEAR(first_moment, 1, 0.03);
    const BinnedMeans& profile = r[Field::solid_fraction];
    for (const Mean& mean : profile.means) {
        solid += mean.value / static_cast<double>(profile.means.size());
    }
    EXPECT_NEAR(solid, value(r, Observable::solid_fraction), 2e-3);
    // Uniform shear: the velocity follows the place; contacts gather where shear compresses,
    // between 90 and 180 degrees.
    const BinnedMeans& velocity = r[Field::velocity];
    for (std::size_t k = 0; k < velocity.at.size(); ++k) {
        EXPECT_NEAR(velocity.means[k].value, velocity.at[k], 0.1);
        EXPECT_GT(r[Field::granular_temperature].means[k].value, 0);
    }
    double compressed = 0;
    for (std::size_t k = 18; k < 36; ++k) {
        compressed += r[Field::contact_orientation].means[k].value * per_radian;
    }
    EXPECT_GT(compressed, 0.53);
    EXPECT_TRUE(simulate(small_run())[Field::distant_gap].means.empty());
}

TEST(Run, IsTheSameForTheSameNumberOfThreads) {
    RunParameters p = small_run();
    p.strain = 0.5;
    expect_same(simulate(p, {.threads = 2}), simulate(p, {.threads = 2}));
    EXPECT_THROW(simulate(small_run(), {.threads = 0}), std::invalid_argument);
}

TEST(Checkpoints, ResumeBitForBit) {
    const TemporaryFolder folder;
    for (const RunParameters& p : {small_run(), small_wet_run()}) {
        expect_same(in_pieces(p, folder.path() / "run"), simulate(p));
        std::filesystem::remove(folder.path() / "run");
    }
    RunParameters p = small_run();
    p.strain = 0.6;
    expect_same(in_pieces(p, folder.path() / "run", 2), simulate(p, {.threads = 2}));
}

TEST(Checkpoints, AreWrittenAsTimePassesAndChangeNothing) {
    const TemporaryFolder folder;
    Checkpoint checkpoint(folder.path() / "run", std::chrono::seconds(0));  // always due
    RunParameters p = small_run();
    p.strain = 0.5;
    expect_same(simulate(p, {.checkpoint = &checkpoint}), simulate(p));
    EXPECT_TRUE(checkpoint.exists());
    // Its process was killed between two of them: what comes after is done again.
    expect_same(simulate(p, {.checkpoint = &checkpoint}), simulate(p));
}

TEST(Checkpoints, OfOtherRunsAreRefusedWithTheReason) {
    const TemporaryFolder folder;
    const auto file = folder.path() / "run";
    put_down(small_run(), file);
    RunParameters other = small_run();
    other.friction = 0.3;
    expect_told({complaint(other, file), complaint(small_wet_run(), file),
                 complaint(small_run(), file, 2)});
}

TEST(Checkpoints, ThatAreNotWholeAreRefused) {
    const TemporaryFolder folder;
    const auto file = folder.path() / "run";
    put_down(small_run(), file);
    const std::string whole = content_of(file);
    const auto with = [&](const std::string& content) {
        std::ofstream(file, std::ios::binary) << content;
        return complaint(small_run(), file);
    };
    expect_told({with(whole.substr(0, whole.size() / 2))});
    std::string flipped = whole;
    flipped[whole.size() - 100] ^= 1;
    expect_told({with(flipped)});
    std::string newer = whole;
    newer.replace(newer.find("format 4"), 8, "format 7");
    expect_told({with(newer)});
    // A size that, with the two lines before the content, exceeds what an integer holds.
    expect_told({with("pendular checkpoint, format 4\nchecksum 0 of 18446744073709551615"),
                 with("friction,stress\n"), with("")});
}

TEST(Checkpoints, AreUsedByOneProcessAtATime) {
    const TemporaryFolder folder;
    {
        const Checkpoint first(folder.path() / "run");
        EXPECT_THROW(Checkpoint(folder.path() / "run"), InputError);
    }
    EXPECT_NO_THROW(Checkpoint(folder.path() / "run"));
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));  // no lock stays behind
}

TEST(Checkpoints, SurviveAFullDisk) {
    const TemporaryFolder folder;
    Checkpoint checkpoint(folder.path() / "run");
    checkpoint.write("friction = 1\n", "state");
    rlimit before = {};
    getrlimit(RLIMIT_FSIZE, &before);
    rlimit full = before;
    full.rlim_cur = 4096;
    std::signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &full);
    std::string message;
    try {
        checkpoint.write("friction = 1\n", std::string(100000, 'x'));
    } catch (const std::runtime_error& error) {
        message = error.what();
    }
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, SIG_DFL);
    EXPECT_THAT(message, testing::EndsWith("the former checkpoint is still there"));
    EXPECT_EQ(checkpoint.read("friction = 1\n"), "state");
}

}  // namespace sim_output_test
