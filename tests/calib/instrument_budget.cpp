// Errors that all readings share, in the errors of fitted parameters.
#include "calib/fit/parameter_errors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "calib/fit/calibrate_study.h"
#include "calib/model/discrepancy.h"
#include "data/recordings/reading_groups.h"
#include "tests/physics/planted_readings.h"

namespace calib_instrument_budget_test {

using namespace pendular;

Study stating(std::vector<StatedUncertainty> stated) {
    Study study = planted_study();
    study.instrument.stated = std::move(stated);
    return study;
}

std::shared_ptr<const EffectModel> predictor_of(const Study& study) {
    const std::shared_ptr<const EmulatedSimulation> simulation(std::shared_ptr<void>(),
                                                               &models().simulation());
    return assemble_model(study, simulation, {});
}

Fit fit_of(const Study& study, const std::vector<Reading>& readings) {
    const auto predictor = predictor_of(study);
    const ResolvedStudy resolved(study);
    const std::vector<DirectMeasurement>& direct = resolved.direct();
    Fit result = fit(ModelOfReadings(predictor, conditions_of(readings), direct),
                     stack(readings, direct), Eigen::VectorXd::Constant(1, 0.2));
    add_instrument(result, *predictor, readings, direct);
    return result;
}

const InstrumentError& named(const Fit& fit, const std::string& name) {
    return *std::ranges::find(fit.instrument, name, &InstrumentError::name);
}

TEST(InstrumentBudget, AddsWhatIsStatedToTheErrorsOfPredictions) {
    const Eigen::VectorXd friction = Eigen::VectorXd::Constant(1, planted_friction);
    const auto exact = predictor_of(planted_study())->predict(friction, conditions());
    const auto stated =
        predictor_of(stating({{"torque-gain", "2 %"}}))->predict(friction, conditions());
    EXPECT_EQ(stated.value, exact.value);
    Eigen::VectorXd change = Eigen::VectorXd::Zero(exact.value.size());
    for (Eigen::Index k = 0; k < change.size(); k += 2)
        change(k) = 0.02 * exact.value(k);
    EXPECT_TRUE(stated.covariance.isApprox(exact.covariance + change * change.transpose(), 1e-6));
}

// What the budget says of a gain is what a fit to readings with that gain gives.
TEST(InstrumentBudget, ShiftsAsAFitToReadingsWithTheErrorMoves) {
    std::vector<Reading> readings = readings_with({}, 3);
    const Fit before = fit_of(planted_study(), readings);
    for (Reading& reading : readings)
        reading.value(0) *= 1.02;
    const Fit after = fit_of(planted_study(), readings);
    const InstrumentError& gain = named(before, "torque-gain");
    EXPECT_FALSE(gain.counts);
    const double moved = after.parameters(0) - before.parameters(0);
    EXPECT_NEAR(gain.shift(0), moved, 0.1 * moved);
    EXPECT_GT(moved, 0);
}

TEST(InstrumentBudget, AddsUpToTheStandardError) {
    const Fit fit =
        fit_of(stating({{"torque-gain", "2 %"}, {"density", "1 %"}, {"height-offset", "30 um"}}),
               readings_with({}, 4));
    const double parts = std::pow(fit.measurement_error(0), 2) +
                         std::pow(fit.simulation_error(0), 2) +
                         std::pow(fit.instrument_error(0), 2);
    EXPECT_NEAR(std::sqrt(parts), fit.standard_error(0), 1e-6 * fit.standard_error(0));
    EXPECT_GT(fit.instrument_error(0), 0.5 * fit.measurement_error(0));
    const auto largest = largest_errors(fit, 0, true, 3);
    EXPECT_EQ(largest.front().name, "torque-gain");
    EXPECT_TRUE(far_errors(fit).empty());
}

/// A study that states a gain of the torque and has measured it.
Study measuring(const std::string& gain, const std::string& error,
                std::vector<StatedUncertainty> stated = {{"torque-gain", "2 %"}}) {
    Study study = stating(std::move(stated));
    study.direct = {{.effect = "torque-gain", .value = gain, .error = error}};
    return study;
}

// A measured gain is what was stated, known better: as if the readings had been divided by it.
TEST(InstrumentBudget, IsNarrowedByADirectMeasurement) {
    std::vector<Reading> readings = readings_with({}, 6);
    const Fit exact = fit_of(planted_study(), readings);
    const Fit stated = fit_of(stating({{"torque-gain", "2 %"}}), readings);
    for (Reading& reading : readings)
        reading.value(0) *= 1.03;
    const Fit high = fit_of(planted_study(), readings);
    const Fit measured = fit_of(measuring("1.03", "0.001"), readings);
    EXPECT_GT(high.parameters(0) - exact.parameters(0), 3 * exact.standard_error(0));
    EXPECT_NEAR(measured.parameters(0), exact.parameters(0), 0.3 * exact.standard_error(0));
    EXPECT_GT(stated.standard_error(0), 1.5 * exact.standard_error(0));
    EXPECT_LT(measured.standard_error(0), 1.1 * exact.standard_error(0));
    // Residuals are 3 % larger too, but not their errors: 6 % of chi2.
    EXPECT_NEAR(measured.chi2, exact.chi2 + std::pow(0.03 / 0.02, 2), 0.06 * exact.chi2);
    EXPECT_NEAR(named(measured, "torque-gain").needed, 0.03 / 0.02, 0.1);
}

TEST(InstrumentBudget, LeavesOfATypicalErrorWhatAMeasurementDoesNotKnow) {
    const std::vector<Reading> readings = readings_with({}, 7);
    const double typical = named(fit_of(planted_study(), readings), "torque-gain").shift(0);
    const double left =
        named(fit_of(measuring("1", "0.2 %", {}), readings), "torque-gain").shift(0);
    EXPECT_NEAR(left / typical, 1 / std::sqrt(1 + std::pow(0.02 / 0.002, 2)), 1e-3);
}

TEST(InstrumentBudget, NamesAnErrorFarBeyondItsUncertainty) {
    std::vector<Reading> readings = readings_with({}, 5);
    for (Reading& reading : readings)
        reading.value(1) *= 1.03;
    const auto far =
        far_errors(fit_of(stating({{"bead_mass", "0.5 %"}, {"torque-gain", "2 %"}}), readings));
    ASSERT_FALSE(far.empty());
    EXPECT_EQ(far.front().name, "bead_mass");
}

// What no reading tells apart is one cause in the budget, under the name of its largest part, with
// the effects of the instrument whose size nobody states.
TEST(InstrumentBudget, NamesWhatActsAlike) {
    const Fit fit = fit_of(planted_study(), readings_with({}, 3));
    const std::vector<std::pair<std::string, std::vector<std::string>>> expected = {
        {"torque-gain", {"normal-force-gain", "cross-talk", "wall-friction"}},
        {"bead_mass", {"density", "height-offset"}},
        {"torque-offset", {"normal-force-offset"}},
        {"angular_velocity", {"lid-slip"}}};  // the diameter scales cohesion too
    for (const auto& [name, others] : expected)
        for (const std::string& other : others)
            EXPECT_THAT(named(fit, name).alike, testing::Contains(other)) << name;
    EXPECT_THAT(named(fit, "torque-gain").alike, testing::Not(testing::Contains("bead_mass")));
    const auto in_budget = [&](const std::string& name) {
        return std::ranges::count(fit.instrument, name, &InstrumentError::name);
    };
    EXPECT_EQ(in_budget("torque-gain"), 1);
    EXPECT_EQ(in_budget("wall-friction"), 0);
    const auto causes = largest_causes(fit, 0, false, 3);
    ASSERT_EQ(causes.size(), 3U);
    for (const SharedCause& each : causes)
        for (const SharedCause& other : causes)
            EXPECT_THAT(each.largest.alike, testing::Not(testing::Contains(other.largest.name)));
    EXPECT_GE(causes[0].together, causes[1].together);
    // Gains of torque and force act alike: who measures the torque's is left with the force's.
    const auto gain = std::ranges::find(causes, std::string("torque-gain"),
                                        [](const SharedCause& each) { return each.largest.name; });
    ASSERT_NE(gain, causes.end());
    EXPECT_GE(gain->together, std::hypot(named(fit, "torque-gain").shift(0),
                                         named(fit, "normal-force-gain").shift(0)));
}

// Solid fractions of a coarse gap repeat to the digit: their scatter is 0.
TEST(InstrumentBudget, NeedsNoScatter) {
    const std::vector<Reading> all = readings_with({}, 3);
    std::vector<Reading> readings;
    for (const auto& group : replicate_groups(all)) {
        Reading& reading = readings.emplace_back(all[group.front()]);
        reading.covariance = Eigen::Vector2d(reading.covariance(0, 0), 0).asDiagonal();
    }
    Study study = planted_study();
    study.model.discrepancy = usual_discrepancy;
    EXPECT_THAT(named(fit_of(study, readings), "bead_mass").alike, testing::Contains("density"));
}

}  // namespace calib_instrument_budget_test
