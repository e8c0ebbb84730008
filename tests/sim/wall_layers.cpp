// Torque lost in layers along the side walls: a share of the cross section, and nothing else.
#include <gtest/gtest.h>

#include "sim/catalogue/effect.h"
#include "sim/catalogue/instrument.h"

namespace pendular::sim_wall_layers_test {

constexpr double diameter = 5e-4;

CellState some_cell(double diameters_wide, double height = 6e-3, double normal_stress = 1000,
                    double angular_velocity = 0.1) {
    CellState cell{.height = height,
                   .angular_velocity = angular_velocity,
                   .inner_radius = 0.1,
                   .outer_radius = 0.1 + diameters_wide * diameter,
                   .density = 1050,
                   .diameter = diameter};
    cell.normal_force = normal_stress * cell.area();
    cell.torque = cell.torque_of(0.3 * normal_stress);
    cell.bead_volume = 0.61 * cell.area() * height;
    return cell;
}

/// Share of the torque that is lost.
double lost(const CellState& truth, double on = 1) {
    const InstrumentMap map({{&built_in_effect("wall-layers"), {on}}});
    return 1 - map.show(truth).torque / truth.torque;
}

TEST(WallLayers, TakeTheShareOfAStripBesideEachWall) {
    EXPECT_NEAR(lost(some_cell(24)), 2 * 0.57 / 24, 1e-9);
    EXPECT_NEAR(lost(some_cell(48)), lost(some_cell(24)) / 2, 1e-9);
    EXPECT_EQ(lost(some_cell(24), 0), 0);
    // Where the layers of both walls meet, nobody knows.
    EXPECT_NEAR(lost(some_cell(3)), lost(some_cell(10)), 1e-9);
}

TEST(WallLayers, AreTheSameAtEachHeightLoadAndSpeed) {
    const double loss = lost(some_cell(24));
    EXPECT_NEAR(lost(some_cell(24, 12e-3)), loss, 1e-12);
    EXPECT_NEAR(lost(some_cell(24, 6e-3, 300)), loss, 1e-12);
    EXPECT_NEAR(lost(some_cell(24, 6e-3, 1000, 1)), loss, 1e-12);
}

TEST(WallLayers, ChangeTheTorqueAlone) {
    const CellState truth = some_cell(24);
    const CellState shown = InstrumentMap({{&built_in_effect("wall-layers"), {1}}}).show(truth);
    EXPECT_EQ(shown.normal_force, truth.normal_force);
    EXPECT_EQ(shown.height, truth.height);
    EXPECT_EQ(shown.angular_velocity, truth.angular_velocity);
    EXPECT_EQ(shown.bead_volume, truth.bead_volume);
}

}  // namespace pendular::sim_wall_layers_test
