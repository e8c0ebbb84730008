// Walls of unknown friction in the error of a fitted friction.
#include "sim/catalogue/unknown_walls.h"

#include <gtest/gtest.h>

#include <cmath>

#include "calib/fit/calibrate_study.h"
#include "calib/fit/parameter_errors.h"
#include "data/sheared_layer.h"
#include "sim/catalogue/instrument.h"
#include "tests/physics/planted_readings.h"

namespace calib_unknown_walls_test {

using namespace pendular;

/// The planted study in a cell of the same area whose walls are 24 diameters apart.
Study narrow_study() {
    Study study = planted_study();
    study.cell->inner_radius = 60e-3;
    study.cell->outer_radius = 72e-3;
    return study;
}

/// Readings as walls show them that mobilise this friction in the sheared layer.
/// @param power -1: as walls of the opposite consequence, which there are not
std::vector<Reading> between_walls(std::vector<Reading> readings, double mobilised_friction,
                                   int power = 1) {
    const Study study = narrow_study();
    const InstrumentMap map({{&built_in_effect("shear-localisation"), {mobilised_friction}}});
    for (Reading& reading : readings) {
        const CellState truth = shown_state(reading.condition, reading.value(0), reading.value(1),
                                            *study.cell, study.grains);
        reading.value(0) *= std::pow(map.show(truth).torque / truth.torque, power);
    }
    return readings;
}

/// @param at_bound what the fit is to say of its friction
Fit fit_of(const Study& study, const std::vector<Reading>& readings, bool at_bound = false) {
    const std::shared_ptr<const EmulatedSimulation> simulation(std::shared_ptr<void>(),
                                                               &models().simulation());
    const auto predictor = assemble_model(study, simulation, {});
    Fit result = fit(ModelOfReadings(predictor, conditions_of(readings), {}), stack(readings, {}),
                     Eigen::VectorXd::Constant(1, 0.2));
    result.at_bound.front() = at_bound;
    add_instrument(result, *predictor, readings, {});
    return result;
}

const InstrumentError* part(const Fit& fit, std::string_view name) {
    const auto found = std::ranges::find(fit.instrument, name, &InstrumentError::name);
    return found == fit.instrument.end() ? nullptr : &*found;
}

double total_error(const Fit& fit) {
    return std::hypot(fit.standard_error(0), fit.instrument_error(0, false));
}

// The part of the walls is what a fit to the readings without them moves back.
TEST(UnknownWalls, ShiftAsAFitToReadingsBetweenSuchWallsMoves) {
    const std::vector<Reading> readings = readings_with({}, 3);
    const Fit without = fit_of(narrow_study(), readings);
    ASSERT_NE(part(without, unknown_wall_friction), nullptr);
    const double friction = part(without, unknown_wall_friction)->standard;
    const Fit with = fit_of(narrow_study(), between_walls(readings, friction));
    const double moved = with.parameters(0) - without.parameters(0);
    EXPECT_GT(moved, 0.03);
    EXPECT_NEAR(part(with, unknown_wall_friction)->shift(0), moved, 0.1 * moved);
}

// A parameter at a bound cannot follow: the part of the walls is then the one in proportion.
TEST(UnknownWalls, ShiftInProportionWhereAParameterIsAtABound) {
    const auto readings = between_walls(readings_with({}, 3), mobilised(0.15));
    const Fit free = fit_of(narrow_study(), readings),
              at_bound = fit_of(narrow_study(), readings, true);
    const double of_fit = part(free, unknown_wall_friction)->shift(0),
                 in_proportion = part(at_bound, unknown_wall_friction)->shift(0);
    EXPECT_GT(in_proportion, 0);
    EXPECT_GT(std::abs(in_proportion - of_fit), 0.05 * of_fit);
    EXPECT_EQ(part(free, "torque-gain")->shift(0), part(at_bound, "torque-gain")->shift(0));
}

// Readings that would need walls of the opposite consequence need something else.
TEST(UnknownWalls, AreNeededWithTheirSignAlone) {
    const auto readings = readings_with({}, 3);
    const Fit with = fit_of(narrow_study(), between_walls(readings, mobilised(0.3)));
    EXPECT_GT(part(with, unknown_wall_friction)->needed, 0);
    const Fit against = fit_of(narrow_study(), between_walls(readings, mobilised(0.3), -1));
    EXPECT_EQ(part(against, unknown_wall_friction)->needed, 0);
}

// The friction of beads between walls of unknown friction is believed only as far as the walls
// allow; stated walls leave the typical errors of an instrument.
TEST(UnknownWalls, CoverTheTruthOfReadingsBetweenRoughWalls) {
    const auto readings = between_walls(readings_with({}, 3), mobilised(0.3));
    Study stating_walls = narrow_study();
    stating_walls.cell->wall_friction = 0.3;
    const Fit unknown = fit_of(narrow_study(), readings), stated = fit_of(stating_walls, readings);
    EXPECT_EQ(unknown.parameters(0), stated.parameters(0));
    const double off = unknown.parameters(0) - planted_friction;
    EXPECT_LT(off, 2 * total_error(unknown));
    EXPECT_GT(off, 2 * total_error(stated));
    EXPECT_EQ(part(stated, unknown_wall_friction), nullptr);
}

}  // namespace calib_unknown_walls_test
