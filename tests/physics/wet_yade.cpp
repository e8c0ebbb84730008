// The same wet flow simulated by YADE (bench/wet_strength.py): an independent code with the same
// bridge force, in five states. Where one code was wrong, e.g. in the sign or the unit of capillary
// forces, in the rupture or in the hysteresis of bridges, structure and stresses would differ by
// far more than the errors.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <thread>

#include "sim/runs/ensemble.h"

namespace wet_yade_test {

using namespace pendular;
using dem::Observable;

/// Quantities of one state that YADE found, with their standard errors.
struct State {
    double friction = 0, reduced_pressure = 0, bridge_volume = 0;
    std::map<std::string, Mean> found;
};

std::map<std::string, State> states_of_yade() {
    std::ifstream file(PENDULAR_SOURCE_DIR "/bench/results/wet_strength.csv");
    std::map<std::string, State> states;
    std::string line;
    while (std::getline(file, line)) {
        if (line.starts_with('#') || line.starts_with("state,")) continue;
        std::ranges::replace(line, ',', ' ');
        std::istringstream cells(line);
        std::string name, quantity;
        State state;
        double strain = 0;
        Mean mean;
        cells >> name >> state.friction >> state.reduced_pressure >> state.bridge_volume >>
            strain >> quantity >> mean.value >> mean.standard_error;
        EXPECT_TRUE(cells) << line;
        State& known = states.try_emplace(name, state).first->second;
        known.found[quantity] = mean;
    }
    return states;
}

TEST(WetYade, FindsTheSameStrengthAndStructure) {
    const auto states = states_of_yade();
    ASSERT_EQ(states.size(), 5u);
    std::vector<dem::RunParameters> parameters;
    for (const auto& [name, state] : states) {
        parameters.push_back({.friction = state.friction,
                              .inertial_number = 0.01,
                              .stiffness_number = 1000,
                              .wetting = dem::Wetting{state.reduced_pressure, state.bridge_volume},
                              .grains = 1000,
                              .strain = 6,
                              .seed = 2027});
    }
    const auto runs =
        run_all(parameters,
                {.threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()))});
    double sum = 0, weights = 0;
    std::size_t k = 0;
    for (const auto& [name, state] : states) {
        const dem::RunResult& run = runs[k++];
        EXPECT_TRUE(run.steady) << name;
        const auto difference = [&](Observable which, const char* quantity, double systematic) {
            const Mean& theirs = state.found.at(quantity);
            const double apart = run[which].value - theirs.value;
            EXPECT_LT(std::abs(apart),
                      4 * std::hypot(run[which].standard_error, theirs.standard_error) +
                          systematic * std::abs(theirs.value))
                << name << ": " << quantity << " " << run[which].value << ", YADE " << theirs.value;
            return apart / theirs.value;
        };
        // YADE reads the bridge force from a table, which is right to 0.2 % of F0 (bench/peers).
        constexpr double table = 0.005;
        const double apart = difference(Observable::stress_ratio, "stress_ratio", 0);
        difference(Observable::solid_fraction, "solid_fraction", 0.001);
        difference(Observable::contact_coordination, "contact_coordination", table);
        difference(Observable::distant_coordination, "distant_coordination", table);
        difference(Observable::distant_force, "distant_force", table);
        difference(Observable::fabric_12_distant, "fabric_12_distant", table);
        difference(Observable::capillary_stress_22, "capillary_stress_22", table);
        difference(Observable::capillary_shear_stress, "capillary_shear_stress", table);
        const Mean& theirs = state.found.at("stress_ratio");
        const double error =
            std::hypot(run[Observable::stress_ratio].standard_error, theirs.standard_error) /
            theirs.value;
        sum += apart / (error * error);
        weights += 1 / (error * error);
    }
    const double error = 1 / std::sqrt(weights);
    RecordProperty("mean_relative_difference_of_stress_ratio", std::to_string(sum / weights));
    RecordProperty("standard_error", std::to_string(error));
    EXPECT_LT(std::abs(sum / weights), 3 * error);
    EXPECT_LT(3 * error, 0.02) << "such a difference could not be seen";
}

}  // namespace wet_yade_test
