// What a study does not say of close side walls, as errors that all its readings share.
#include "sim/catalogue/unknown_walls.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "sim/catalogue/instrument.h"
#include "sim/catalogue/shared_uncertainty.h"

namespace pendular::sim_unknown_walls_test {

constexpr double diameter = 5e-4;

/// Study between side walls so many diameters apart.
Study study_of_width(double diameters) {
    Study study;
    study.grains = {.diameter = diameter, .density = 1050};
    study.cell = AnnularCell{0.1, 0.1 + diameters * diameter, 57e-6};
    return study;
}

std::optional<SharedUncertainty> error_of(const Study& study, const std::string& name) {
    const auto all = shared_uncertainties(study);
    const auto found = std::ranges::find(all, name, &SharedUncertainty::name);
    return found == all.end() ? std::nullopt : std::optional(*found);
}

bool has(const Study& study, const std::string& name) {
    return error_of(study, name).has_value();
}

TEST(UnknownWalls, AreAnErrorUntilTheirFrictionIsStated) {
    Study study = study_of_width(24);
    EXPECT_TRUE(has(study, "wall_friction"));
    study.cell->wall_friction = 0.15;
    EXPECT_FALSE(has(study, "wall_friction"));
    study.cell->wall_friction = 0;
    EXPECT_FALSE(has(study, "wall_friction"));
    study.cell->wall_friction.reset();
    for (const char* effect : {"shear-localisation", "wall-friction"}) {
        study.instrument.stated = {{effect, "0.03"}};
        EXPECT_FALSE(has(study, "wall_friction")) << effect;
    }
    study.instrument.stated.clear();
    study.direct = {{.effect = "wall-friction", .value = "", .error = ""}};
    EXPECT_TRUE(has(study, "wall_friction")) << "not measured yet";
    study.direct = {{.effect = "wall-friction", .value = "0.15", .error = "0.01"}};
    EXPECT_FALSE(has(study, "wall_friction"));
}

// The effect of the same walls on a bed that is sheared evenly is no further cause.
TEST(UnknownWalls, StandForAllEffectsOfTheirFriction) {
    EXPECT_FALSE(has(study_of_width(24), "wall-friction"));
    EXPECT_TRUE(has(study_of_width(48), "wall-friction"));
}

TEST(UnknownWalls, AreNoErrorWhereTheyAreFarOrMissing) {
    EXPECT_TRUE(has(study_of_width(37.9), "wall_friction"));
    EXPECT_FALSE(has(study_of_width(38.1), "wall_friction"));
    EXPECT_FALSE(has(study_of_width(38.1), "wall-layers"));
    Study table = study_of_width(24);
    table.cell.reset();
    EXPECT_FALSE(has(table, "wall_friction"));
}

// A fit would use what counts with either sign.
TEST(UnknownWalls, NeverCountAmongTheWeights) {
    Study study = study_of_width(24);
    study.instrument.kind = InstrumentTable::Class::rheometer;
    for (const char* name : {"wall_friction", "wall-layers"})
        EXPECT_FALSE(error_of(study, name).value().counts) << name;
    EXPECT_TRUE(error_of(study, "torque-gain").value().counts);
}

// Walls hold grains back, layers let them go: neither error has the other sign.
TEST(UnknownWalls, ChangeTheTorqueToOneSide) {
    CellState state{.height = 12 * diameter,
                    .inner_radius = 0.1,
                    .outer_radius = 0.1 + 24 * diameter,
                    .density = 1050,
                    .diameter = diameter};
    state.normal_force = 1000 * state.area();
    state.torque = state.torque_of(294);
    state.angular_velocity = 2;
    state.bead_volume = 0.6 * state.area() * state.height;
    const auto friction = error_of(study_of_width(24), "wall_friction").value(),
               layers = error_of(study_of_width(24), "wall-layers").value();
    const auto shown = [&](const SharedUncertainty& error) {
        return InstrumentMap(error.error(false)).show(state).torque / state.torque;
    };
    EXPECT_GT(shown(friction), 1.05);
    EXPECT_LT(shown(friction), 1.2);
    EXPECT_NEAR(shown(layers), 1 - 2 * 0.57 / 24 / std::sqrt(3), 1e-9);
    for (const SharedUncertainty& each : {friction, layers})
        EXPECT_TRUE(InstrumentMap(each.error(true)).empty()) << each.name;
}

}  // namespace pendular::sim_unknown_walls_test
