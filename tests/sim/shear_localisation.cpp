// Side walls that gather the shear under the lid: what the effect shows, and what tells it from the
// wall friction of a bed that is sheared evenly.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "data/sheared_layer.h"
#include "sim/catalogue/effect.h"
#include "sim/catalogue/instrument.h"

namespace pendular::sim_shear_localisation_test {

constexpr double diameter = 5e-4, density = 1050;

/// State of even shear of beads of friction 0.12 in an annulus 24 diameters wide.
CellState even_shear(double diameters_high, double inertial_number, double normal_stress = 1000) {
    CellState cell{.height = diameters_high * diameter,
                   .inner_radius = 0.1,
                   .outer_radius = 0.1 + 24 * diameter,
                   .density = density,
                   .diameter = diameter};
    cell.normal_force = normal_stress * cell.area();
    cell.torque = cell.torque_of((0.2755 + 0.93 * inertial_number) * normal_stress);
    const double mass = std::numbers::pi / 6 * density * std::pow(diameter, 3);
    const double rate = inertial_number / std::sqrt(mass / (diameter * normal_stress));
    cell.angular_velocity = rate * 2 * cell.height / (cell.inner_radius + cell.outer_radius);
    cell.bead_volume = 0.61 * cell.area() * cell.height;
    return cell;
}

/// Shown torque over that without the effect.
double rise(const char* effect, double coefficient, const CellState& truth) {
    const InstrumentMap map({{&built_in_effect(effect), {coefficient}}});
    return map.show(truth).torque / truth.torque;
}

TEST(ShearLocalisation, RaisesTheTorqueToThatOfTheLayerUnderTheLid) {
    const ShearedLayer layer = sheared_layer({.height = 12,
                                              .width = 24,
                                              .wall_friction = 0.1,
                                              .inertial_number = 0.02,
                                              .stress_ratio = 0.2755 + 0.93 * 0.02});
    const CellState truth = even_shear(12, 0.02);
    EXPECT_NEAR(rise("shear-localisation", 0.1, truth), layer.stress_ratio / 0.2941, 1e-6);
    const CellState shown =
        InstrumentMap({{&built_in_effect("shear-localisation"), {0.1}}}).show(truth);
    EXPECT_EQ(shown.normal_force, truth.normal_force);  // walls carry none of the load
    EXPECT_EQ(shown.angular_velocity, truth.angular_velocity);
}

TEST(ShearLocalisation, IsToldFromWallFrictionByHeightAndSpeed) {
    // Of a bed twice as high as the layer, the walls drag no more on the lid; of one that is
    // sheared evenly, twice as much. The lid's speed is that of the lower bed.
    const auto growth = [](const char* effect, const CellState& from, const CellState& to) {
        return (rise(effect, 0.1, to) - 1) / (rise(effect, 0.1, from) - 1);
    };
    const CellState bed = even_shear(24, 0.01), higher = even_shear(48, 0.005);
    EXPECT_NEAR(growth("wall-friction", bed, higher), 2, 0.1);
    EXPECT_LT(growth("shear-localisation", bed, higher), 1.2);
    // Three times the speed thickens the layer.
    const CellState faster = even_shear(24, 0.03);
    EXPECT_LT(growth("wall-friction", bed, faster), 1);
    EXPECT_GT(growth("shear-localisation", bed, faster), 1.2);
}

}  // namespace pendular::sim_shear_localisation_test
