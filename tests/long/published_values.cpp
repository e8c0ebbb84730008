// Numbers of Badetti et al. (2018) that single runs decide, at its own size and stiffness: 4000
// beads, stiffness number 8400, inertial number 0.001. Solid fractions are corrected to rigid
// beads. Several hours. tests/physics/published_values.cpp has the short version.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <thread>

#include "sim/runs/ensemble.h"

namespace published_values_test {

using namespace pendular;
using dem::Observable;

dem::RunParameters flow(double friction, double inertial_number,
                        std::optional<dem::Wetting> wetting = {}) {
    return {.friction = friction,
            .inertial_number = inertial_number,
            .stiffness_number = 8400,
            .wetting = wetting,
            .grains = 4000,
            .strain = 6,
            .seed = 1};
}

/// Solid fraction that rigid beads would have.
Mean rigid_solid_fraction(const dem::RunResult& run) {
    Mean mean = run[Observable::solid_fraction];
    const double shift = dem::rigidity_shift(mean.value, run[Observable::overlap].value);
    mean.value -= shift;
    mean.standard_error =
        std::hypot(mean.standard_error, shift * dem::rigidity_factor_error / dem::rigidity_factor);
    return mean;
}

/// Limit of I -> 0 from two inertial numbers of which the second is three times the first, from a
/// range of exponents of I whose ends make the error.
Mean quasi_static(const Mean& slow, const Mean& fast, double lowest = 0.5, double highest = 1) {
    const auto weight = [](double exponent) { return 1 / (std::pow(3, exponent) - 1); };
    const double change = slow.value - fast.value;
    const double middle = weight(0.5 * (lowest + highest));
    return {slow.value + middle * change,
            std::hypot(slow.standard_error * (1 + middle), fast.standard_error * middle,
                       0.5 * (weight(lowest) - weight(highest)) * change)};
}

std::vector<dem::RunResult> results_of(const std::vector<dem::RunParameters>& parameters) {
    const auto runs =
        run_all(parameters,
                {.threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()))});
    for (const auto& run : runs) {
        EXPECT_TRUE(run.failure.empty()) << run.failure;
        EXPECT_TRUE(run.steady);
        EXPECT_FALSE(run.crystallised);
        const Mean &ratio = run[Observable::stress_ratio], fraction = rigid_solid_fraction(run);
        std::printf(
            "friction %.2f, I %.4f: stress ratio %.4f +- %.4f, solid fraction %.4f +- %.4f, "
            "localization %.3f\n",
            run.parameters.friction, run.parameters.inertial_number, ratio.value,
            ratio.standard_error, fraction.value, fraction.standard_error,
            run[Observable::localization].value);
    }
    return runs;
}

TEST(PublishedValues, AreFoundInDryShear) {
    const auto runs = results_of(
        {flow(0.09, 1e-3), flow(0.09, 3e-3), flow(0, 1e-3), flow(0, 3e-3), flow(0.05, 1e-3)});
    const auto ratio = [&](std::size_t k) { return runs[k][Observable::stress_ratio]; };
    const Mean published = quasi_static(ratio(0), ratio(1));
    EXPECT_NEAR(published.value, 0.257, 3 * std::hypot(0.002, published.standard_error));
    const Mean fraction =
        quasi_static(rigid_solid_fraction(runs[0]), rigid_solid_fraction(runs[1]));
    EXPECT_NEAR(fraction.value, 0.6150, 3 * std::hypot(0.0003, fraction.standard_error));
    // "About" 0.10 and 0.64, and 0.2: half a unit of the last digit, plus errors. Frictionless
    // beads come to their limit as I^0.4 or so (Peyneau and Roux, Phys. Rev. E 78 (2008) 011307).
    const Mean smooth = quasi_static(ratio(2), ratio(3), 0.35, 0.45);
    EXPECT_NEAR(smooth.value, 0.10, 0.005 + 3 * smooth.standard_error);
    EXPECT_NEAR(rigid_solid_fraction(runs[2]).value, 0.64, 0.005);
    EXPECT_NEAR(ratio(4).value, 0.2, 0.02 + 3 * ratio(4).standard_error);
    for (const auto& run : runs) {
        EXPECT_LT(run[Observable::localization].value, 0.05);
    }
}

TEST(PublishedValues, AreFoundInWetShear) {
    const auto runs =
        results_of({flow(0.09, 1e-3, {{.reduced_pressure = 1, .bridge_volume = 1e-3}}),
                    flow(0.09, 1e-3, {{.reduced_pressure = 1, .bridge_volume = 4e-3}}),
                    flow(0.25, 1e-3, {{.reduced_pressure = 0.5, .bridge_volume = 8e-3}})});
    // 0.594, "independent of liquid content"; independent simulations 0.588 to 0.592.
    for (const std::size_t k : {0, 1}) {
        const Mean fraction = rigid_solid_fraction(runs[k]);
        EXPECT_NEAR(fraction.value, 0.594, 0.006 + 2 * fraction.standard_error);
        EXPECT_LT(runs[k][Observable::localization].value, 0.05);
    }
    EXPECT_NEAR(rigid_solid_fraction(runs[0]).value, rigid_solid_fraction(runs[1]).value, 0.004);
    // "Close to one."
    const Mean& strongest = runs[2][Observable::stress_ratio];
    EXPECT_NEAR(strongest.value, 1, 0.05 + 2 * strongest.standard_error);
}

}  // namespace published_values_test
