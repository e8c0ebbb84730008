// Twenty planted frictions, each with simulation seeds and a size of its own: is the reported
// standard error the scatter there really is?
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>
#include <thread>

#include "calib/fit/calibrate_study.h"
#include "calib/fit/calibration.h"

namespace planted_truths_test {

using namespace pendular;

constexpr int truths = 20;
/// At inertial number 0.02 the solver is fast and the fit the same.
const Fidelity fidelity{"planted", 1000, 1000, 0.02, 5};

/// Readings of a hidden friction: long runs of 1400 beads plus drawn measurement errors.
Measurements readings_of(double friction, int study, int threads) {
    std::vector<dem::RunParameters> runs;
    for (std::uint64_t k = 0; k < 4; ++k) {
        runs.push_back({.friction = friction,
                        .inertial_number = 0.02,
                        .stiffness_number = 1000,
                        .grains = 1400,
                        .strain = 10,
                        .seed = 70'000 + 10 * static_cast<std::uint64_t>(study) + k});
    }
    double ratio = 0, fraction = 0;
    for (const auto& run : run_all(runs, {.threads = threads})) {
        ratio += run[dem::Observable::stress_ratio].value / 4;
        fraction += run[dem::Observable::solid_fraction].value / 4;
    }
    std::mt19937_64 random(8'000 + static_cast<unsigned>(study));
    std::normal_distribution<double> normal;
    Measurements measurements;
    for (const double stress : {300.0, 1000.0, 3000.0}) {
        const double ratio_error = 0.02 * ratio, fraction_error = 0.002;
        Reading reading;
        reading.condition = {.normal_stress = stress, .inertial_number = 0.02};
        reading.value << (ratio + ratio_error * normal(random)) * stress,
            fraction + fraction_error * normal(random);
        reading.covariance << std::pow(ratio_error * stress, 2), 0, 0, std::pow(fraction_error, 2);
        measurements.readings.push_back(reading);
    }
    return measurements;
}

TEST(PlantedTruths, ScatterAsTheReportedErrorSays) {
    const int threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    Study study;
    study.grains = {.diameter = 5e-4, .density = 1050};
    double square = 0;
    for (int k = 0; k < truths; ++k) {
        const double truth = 0.05 + 0.35 * k / (truths - 1);
        const Calibration c =
            calibrate_study(study, readings_of(truth, k, threads),
                            {.fidelity = fidelity, .seed = static_cast<std::uint64_t>(100 + k)},
                            {.threads = threads});
        const double z = (c.fit.parameters(0) - truth) / c.fit.standard_error(0);
        std::printf("truth %.4f: %.4f +- %.4f (simulation %.4f), z = %+.2f, %zu runs\n", truth,
                    c.fit.parameters(0), c.fit.standard_error(0), c.fit.simulation_error(0), z,
                    c.runs.size());
        std::fflush(stdout);
        EXPECT_TRUE(c.fit.converged);
        square += z * z / truths;
    }
    std::printf("scatter over reported standard error: %.2f\n", std::sqrt(square));
    EXPECT_GT(std::sqrt(square), 1 / 1.5);
    EXPECT_LT(std::sqrt(square), 1.5);
}

}  // namespace planted_truths_test
