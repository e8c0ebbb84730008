// Friction at the side walls: slices of the bed add up to the effect, and simulated walls bear out
// how much of it acts along the flow and against the load.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "sim/catalogue/effect.h"
#include "sim/catalogue/instrument.h"
#include "sim/effects/wall_mobilisation.h"

namespace pendular::sim_wall_friction_test {

constexpr double diameter = 5e-4;

CellState some_cell(double diameters_high, double diameters_wide) {
    CellState cell{.height = diameters_high * diameter,
                   .angular_velocity = 0.1,
                   .inner_radius = 0.021,
                   .outer_radius = 0.021 + diameters_wide * diameter,
                   .density = 1050,
                   .diameter = diameter};
    cell.normal_force = 700 * cell.area();
    cell.torque = cell.torque_of(230);
    cell.bead_volume = 0.61 * cell.area() * cell.height;
    return cell;
}

/// Rate x sqrt(mass/(diameter x stress)) [1].
double inertial_number(const CellState& cell) {
    const double rate =
        cell.angular_velocity * (cell.inner_radius + cell.outer_radius) / 2 / cell.height;
    const double mass = std::numbers::pi / 6 * cell.density * std::pow(diameter, 3);
    return rate * std::sqrt(mass / diameter * cell.area() / cell.normal_force);
}

CellState shown(const CellState& truth, double coefficient) {
    return InstrumentMap({{&built_in_effect("wall-friction"), {coefficient}}}).show(truth);
}

TEST(WallFriction, IsWhatSlicesOfTheSampleAddUpTo) {
    // A thousand slices from mid-height to the lid: each is held by friction k s22 at both walls,
    // sideways against the lid by the share of a grain that slides, and down against the load. The
    // torque's formula leaves out that the force rises on the way, a part of k H/(2 w) at most.
    constexpr double pi = std::numbers::pi;
    for (const double height : {6.0, 38.0}) {
        const double coefficient = 0.1, k = 0.937 * coefficient, slices = 1000;
        const CellState truth = some_cell(height, 48);
        const double inertial = inertial_number(truth);
        const double dz = truth.height / 2 / slices, ri = truth.inner_radius,
                     re = truth.outer_radius;
        double force = truth.normal_force, torque = truth.torque;
        for (int slice = 0; slice < slices; ++slice) {
            const double friction = k * force / truth.area();
            const double above_base = height / 2 + (slice + 0.5) * dz / diameter;
            torque += mobilised_share(above_base, inertial) * friction * 2 * pi *
                      (ri * ri + re * re) * dz;
            force += carrying_share * friction * 2 * pi * (ri + re) * dz;
        }
        const CellState seen = shown(truth, coefficient);
        EXPECT_NEAR(seen.normal_force / force, 1, 1e-5);
        EXPECT_NEAR((seen.torque - truth.torque) / (torque - truth.torque), 1,
                    k * truth.height / truth.width() / 2);
    }
}

/// Layer of a simulated cell that ships (bench/real_cell/profiles.csv), of 1 diameter.
struct Layer {
    double normal_stress, inertial_number, replicate, height, velocity, shear, vertical, lateral,
        flow, fraction, drag, pressure, lift;
};

std::vector<Layer> simulated_layers(const std::string& name) {
    std::ifstream file(std::filesystem::path(PENDULAR_SOURCE_DIR) / "bench/real_cell/profiles.csv");
    std::vector<Layer> layers;
    for (std::string line; std::getline(file, line);) {
        if (!line.starts_with("\"" + name + "\",")) continue;
        std::istringstream words(line.substr(name.size() + 3));
        double v[13] = {};
        char comma = 0;
        for (double& value : v)
            words >> value >> comma;
        layers.push_back(
            {v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7], v[8], v[9], v[10], v[11], v[12]});
    }
    return layers;
}

/// Part of the load that the walls of simulated cells carry from lid to base, mean of the states.
double carried(const std::vector<Layer>& layers, double width) {
    double sum = 0;
    int states = 0;
    for (std::size_t k = 0; k < layers.size(); ++k) {
        states += k == 0 || layers[k].height < layers[k - 1].height;
        sum -= 2 * layers[k].lift / width;  // layers of 1 diameter; load 1
    }
    return sum / states;
}

TEST(WallFriction, CarriesAsMuchLoadAsSimulatedWalls) {
    // Cells that the share was not taken from. Its states scatter by a fifth. A wall that held the
    // load with all of its friction would carry ten times as much.
    struct Case {
        const char* name;
        double friction, height, width;
    };
    for (const Case& c :
         {Case{"narrow, walls 0.15, height 12", 0.15, 12, 12},
          Case{"walls 0.15, height 24", 0.15, 24, 24}, Case{"walls 0.3, height 24", 0.3, 24, 24}}) {
        const auto layers = simulated_layers(c.name);
        ASSERT_FALSE(layers.empty()) << c.name;
        const CellState truth = some_cell(c.height, c.width);
        // The effect goes from mid-height to the lid.
        const double half = truth.normal_force / shown(truth, c.friction).normal_force;
        EXPECT_NEAR(carried(layers, c.width) / (1 - half * half), 1, 0.25) << c.name;
    }
}

/// Drag on the upper half of an evenly sheared bed, over the load: what the effect adds to the
/// torque over arm and load.
double added_drag(double friction, double height, double width, double inertial_number) {
    return mobilised_in_upper_half(height, inertial_number) * 0.937 * friction * height / width;
}

TEST(WallFriction, DragsAsSimulatedWallsThatShearEvenly) {
    // At wall friction 0.05 and this speed, 0.9 of the bed is sheared.
    const CellState truth = some_cell(12, 24);
    const double arm =
        (truth.inner_radius * truth.inner_radius + truth.outer_radius * truth.outer_radius) /
        (truth.inner_radius + truth.outer_radius);
    EXPECT_NEAR((shown(truth, 0.05).torque - truth.torque) / truth.normal_force / arm /
                    added_drag(0.05, 12, 24, inertial_number(truth)),
                1, 1e-9);
    double drag = 0, states = 0;
    for (const Layer& layer : simulated_layers("walls 0.05, height 12")) {
        if (layer.inertial_number != 0.06) continue;
        states += layer.height < 1;  // the first layer above the base
        if (layer.height > 6) drag += 2 * layer.drag / 24;
    }
    ASSERT_EQ(states, 3);  // loads
    EXPECT_NEAR(drag / states / added_drag(0.05, 12, 24, 0.06), 1, 0.06);
}

TEST(MobilisedShare, IsThatOfSimulatedWallsFromLidToCreepingBed) {
    // The second samples of narrow cells: from the first, the dependence on the inertial number was
    // seen. Of a wall friction of 0.15 beads of friction 0.12 that slide show 0.13 (cells 24 wide).
    auto layers = simulated_layers("narrow, walls 0.15, height 12");
    std::erase_if(layers, [](const Layer& layer) { return layer.replicate != 2; });
    double by_length[4] = {}, expected[4] = {};
    int number[4] = {};
    for (std::size_t k = 1; k + 1 < layers.size(); ++k) {
        const Layer &below = layers[k - 1], &here = layers[k], &above = layers[k + 1];
        if (!(below.height < here.height && here.height < above.height)) continue;  // base or lid
        const double rate = (above.velocity - below.velocity) / 2, length = here.velocity / rate;
        const auto range = static_cast<std::size_t>(std::min(3.0, length / 1.5));
        by_length[range] += here.drag / here.pressure / 0.13;
        expected[range] += mobilised_share(length, rate / std::sqrt(here.vertical));
        ++number[range];
    }
    for (int range = 0; range < 4; ++range) {
        ASSERT_GE(number[range], 5);
        EXPECT_NEAR(by_length[range] / number[range], expected[range] / number[range], 0.1)
            << range;
    }
}

}  // namespace pendular::sim_wall_friction_test
