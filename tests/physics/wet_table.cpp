// Bridge volume against liquid content and the structure of the bridge network, friction 0.09 and
// P* = 3, against Badetti et al.'s table and ranges. Five runs of 1000 beads at kappa 1000 and
// inertial number 0.01; docs/validation.md has the same at Badetti et al.'s stiffness.
#include <gtest/gtest.h>

#include <cmath>
#include <thread>

#include "sim/runs/ensemble.h"

namespace wet_table_test {

using namespace pendular;
using dem::Observable;

struct Row {
    double bridge_volume;   ///< V0/a^3
    double liquid_content;  ///< as printed in Badetti et al.'s table, at P* = 3
    double rounding;        ///< half a unit of its last digit
};
constexpr Row table[] = {{5e-4, 0.003, 5e-4},
                         {1e-3, 0.007, 5e-4},
                         {2e-3, 0.014, 5e-4},
                         {4e-3, 0.030, 5e-4},
                         {8e-3, 0.063, 5e-4}};

TEST(WetShear, HoldsThePublishedLiquidContents) {
    std::vector<dem::RunParameters> parameters;
    for (const auto& row : table) {
        parameters.push_back({.friction = 0.09,
                              .inertial_number = 0.01,
                              .stiffness_number = 1000,
                              .wetting = dem::Wetting{3, row.bridge_volume},
                              .grains = 1000,
                              .strain = 4,
                              .seed = 31});
    }
    const int threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    const auto runs = run_all(parameters, {.threads = threads});
    for (std::size_t k = 0; k < runs.size(); ++k) {
        SCOPED_TRACE(table[k].bridge_volume);
        const auto& run = runs[k];
        const auto value = [&](Observable which) { return run[which].value; };
        EXPECT_TRUE(run.steady);
        EXPECT_NEAR(value(Observable::liquid_content), table[k].liquid_content,
                    std::max(0.07 * table[k].liquid_content, table[k].rounding));
        // Badetti et al.'s ranges over all its states; lengths depend on the stiffness and are held
        // against theirs in docs/validation.md.
        EXPECT_GT(value(Observable::distant_coordination), 1.0);
        EXPECT_LT(value(Observable::distant_coordination), 3.2);
        EXPECT_GT(value(Observable::fabric_12_distant), 0.07);
        EXPECT_LT(value(Observable::fabric_12_distant), 0.14);
        EXPECT_GT(value(Observable::distant_length), 1.02);
        const double reduced = 3 * value(Observable::capillary_shear_stress);  // a^2 s12cap/F0
        EXPECT_GT(reduced, 0);
        EXPECT_LT(reduced, 0.11);
        // Liquid makes bridges longer and more numerous, and takes capillary shear stress away.
        if (k > 0) {
            EXPECT_GT(value(Observable::distant_coordination),
                      runs[k - 1][Observable::distant_coordination].value);
            EXPECT_GT(value(Observable::distant_length),
                      runs[k - 1][Observable::distant_length].value);
            EXPECT_LT(value(Observable::capillary_shear_stress),
                      runs[k - 1][Observable::capillary_shear_stress].value);
        }
    }
    EXPECT_GT(runs.back()[Observable::stress_ratio].value,
              runs.front()[Observable::stress_ratio].value + 0.02);
}

}  // namespace wet_table_test
