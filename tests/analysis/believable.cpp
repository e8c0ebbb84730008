// What a fit may be used for: the table of docs/explanation/diagnosis.md, without a simulation.
#include "analysis/misfit/believable.h"

#include <Eigen/Dense>
#include <cmath>

#include "calib/fit/measured.h"
#include "calib/model/discrepancy.h"
#include "tests/support/golden.h"

namespace analysis_believable_test {

using namespace pendular;
using Degree = Agreement::Degree;

Agreement agreement(double chi2, double chi2_as_inexact) {
    return {.misfit = {chi2, 20},
            .readings = 10,
            .discrepancy = usual_discrepancy,
            .as_inexact = {chi2_as_inexact, 20}};
}

const std::vector<Parameter> friction = {
    {.name = "friction", .unit = "1", .lower = 0, .upper = 0.6, .start = 0.1}};

Fit fit_at(double value) {
    Fit fit;
    fit.parameters = Eigen::VectorXd::Constant(1, value);
    fit.covariance = Eigen::MatrixXd::Constant(1, 1, 1e-4);
    fit.at_bound = {value >= 0.6};
    return fit;
}

Belief belief(const Agreement& fitted, const Fit& fit = fit_at(0.1),
              const Measurements& measurements = {},
              const std::optional<Agreement>& predicted = {}) {
    Measurements some = measurements;
    if (some.readings.empty()) some.readings.resize(10);
    return belief_in(fit, friction, fitted, predicted, some, {});
}

TEST(Agreement, HasThreeDegrees) {
    EXPECT_EQ(agreement(22, 22).degree(), Degree::describes);
    EXPECT_EQ(agreement(38, 38).degree(), Degree::describes);  // p = 0.009, but no sign of more
    EXPECT_EQ(agreement(60, 25).degree(), Degree::nearly);
    EXPECT_EQ(agreement(60, 60).degree(), Degree::fails);
    EXPECT_EQ(agreement(900, 80).degree(), Degree::fails);
}

/// Readings at 20 conditions, of which every other stress ratio is `off` [1] larger than predicted,
/// with errors of 0.1 %.
Agreement agreement_where(double off, const ModelSettings& model) {
    std::vector<Reading> readings;
    for (int k = 0; k < 20; ++k) {
        Reading reading;
        reading.condition = {.normal_stress = 300 * std::pow(1.4, k), .inertial_number = 0.01};
        const double stress = 0.3 * reading.condition.normal_stress;
        reading.value = {stress * (1 + off * (k % 2)), 0.6};
        reading.covariance = Eigen::Vector2d(0.001 * stress, 0.0006).cwiseAbs2().asDiagonal();
        readings.push_back(reading);
    }
    Prediction prediction{
        .value = stack(readings).value, .jacobian = {}, .covariance = {}, .run_noise = {}};
    for (Eigen::Index k = 1; k < 20; k += 2)
        prediction.value(2 * k) /= 1 + off;
    prediction.jacobian = Eigen::MatrixXd::Zero(40, 1);
    prediction.covariance =
        discrepancy_covariance(conditions_of(readings), prediction.value, model.discrepancy);
    prediction.discrepancy = prediction.covariance;
    const Measured measured = stack(readings);
    const Eigen::VectorXd residuals = measured.value - prediction.value;
    const double chi2 =
        residuals.dot((measured.covariance + prediction.covariance).llt().solve(residuals));
    return agreement_of(readings, {}, prediction, {}, {chi2, 40}, model);
}

TEST(Agreement, IsNearWhereTheModelErrsByMoreThanExpectedUnlessThatIsStated) {
    ModelSettings model;
    model.discrepancy = usual_discrepancy;
    EXPECT_EQ(agreement_where(0.002, model).degree(), Degree::describes);
    const Agreement near = agreement_where(0.012, model);
    EXPECT_EQ(near.degree(), Degree::nearly);
    EXPECT_GT(near.discrepancy[0], usual_discrepancy[0]);
    EXPECT_LE(near.discrepancy[0], 0.01 + 1e-12);
    EXPECT_EQ(agreement_where(0.1, model).degree(), Degree::fails);
    model.discrepancy_stated = true;
    const Agreement stated = agreement_where(0.012, model);
    EXPECT_EQ(stated.degree(), Degree::fails);
    EXPECT_EQ(stated.discrepancy, usual_discrepancy);
}

// Errors ten times too large hide a lack of fit, which the scatter of replicates shows.
TEST(Agreement, IsTestedByTheScatterWhereStatedErrorsAreLarger) {
    const auto agreement_with = [](double off, double excess, double freedom = INFINITY) {
        std::vector<Reading> readings;
        for (int k = 0; k < 20; ++k) {
            Reading reading;
            reading.condition = {.normal_stress = 300 * std::pow(1.4, k), .inertial_number = 0.01};
            reading.value = {0.3 * reading.condition.normal_stress * (1 + off * (k % 2)), 0.6};
            reading.covariance =
                Eigen::Vector2d(0.1 * reading.value(0), 0.06).cwiseAbs2().asDiagonal();
            readings.push_back(reading);
        }
        Prediction prediction{.value = stack(readings).value,
                              .jacobian = Eigen::MatrixXd::Zero(40, 1),
                              .covariance = Eigen::MatrixXd::Zero(40, 40),
                              .run_noise = {}};
        for (Eigen::Index k = 1; k < 20; k += 2)
            prediction.value(2 * k) /= 1 + off;
        return agreement_of(readings, {}, prediction, {}, {0.1, 40}, {},
                            {.factor = {excess, 1}, .freedom = freedom});
    };
    EXPECT_FALSE(agreement_with(0.05, 1).by_scatter);
    EXPECT_TRUE(belief(agreement_with(0.005, 10)).believable());
    const Agreement hidden = agreement_with(0.05, 10);
    ASSERT_TRUE(hidden.by_scatter);
    EXPECT_NEAR(hidden.by_scatter->chi2, 10 * std::pow(0.05 / 1.05 / 0.01, 2), 1e-6);
    EXPECT_EQ(hidden.degree(), Degree::describes);
    const Belief none = belief(hidden);
    expect_told(none.reasons);
    // A scatter that one pair of repetitions shows may be small by chance.
    EXPECT_TRUE(belief(agreement_with(0.05, 10, 1)).believable());
}

TEST(Agreement, TakesTheExcessOfErrorsFromTheNotesOfImport) {
    Measurements measurements;
    EXPECT_EQ(excess_of_errors(measurements).factor, (std::array{1.0, 1.0}));
    measurements.remarks = {{.kind = Remark::Kind::errors_above_scatter,
                             .outcome = Remark::Outcome::note,
                             .quantity = "solid_fraction",
                             .relative = 0.25,
                             .freedom = 3}};
    EXPECT_EQ(excess_of_errors(measurements).factor, (std::array{1.0, 4.0}));
    EXPECT_EQ(excess_of_errors(measurements).freedom, 3);
    measurements.remarks.front().relative = 0;
    EXPECT_EQ(excess_of_errors(measurements).factor, (std::array{1.0, 10.0}));
}

TEST(Belief, EndsWhereALargerDiscrepancyDoesNotHelp) {
    EXPECT_TRUE(belief(agreement(22, 22)).believable());
    EXPECT_TRUE(belief(agreement(60, 25)).believable());
    const Belief none = belief(agreement(900, 80));
    ASSERT_FALSE(none.believable());
    EXPECT_EQ(none.misfit_reason, 0U);
    expect_told(none.reasons);
    EXPECT_FALSE(none.meaningless);
    EXPECT_TRUE(belief(agreement(900, 80), fit_at(0.6)).meaningless);
}

TEST(Belief, IsForTheFittedReadingsAloneWherePredictionsFail) {
    const Belief fitted_only = belief(agreement(22, 22), fit_at(0.1), {}, agreement(900, 900));
    EXPECT_FALSE(fitted_only.believable());
    EXPECT_TRUE(fitted_only.for_fitted_only);
    EXPECT_FALSE(belief(agreement(900, 900), fit_at(0.1), {}, agreement(900, 900)).for_fitted_only);
}

TEST(Belief, EndsWhereASharedErrorWouldBeFarAway) {
    Fit fit = fit_at(0.1);
    fit.instrument = {{.name = "torque-gain", .standard = 0.02, .needed = 1.9}};
    EXPECT_TRUE(belief(agreement(22, 22), fit).believable());
    fit.instrument.front().needed = -2.1;
    const Belief far = belief(agreement(22, 22), fit);
    expect_told(far.reasons);
}

TEST(Belief, EndsWhereMostStepsNeverBecameSteady) {
    Measurements few;
    few.readings.resize(2);
    few.remarks.assign(2, {.kind = Remark::Kind::never_steady,
                           .outcome = Remark::Outcome::left_out,
                           .files = {"a.csv"},
                           .lines = {{1, 2}}});
    EXPECT_TRUE(belief(agreement(22, 22), fit_at(0.1), few).believable());
    few.remarks.resize(41, few.remarks.front());
    const Belief lost = belief(agreement(22, 22), fit_at(0.1), few);
    expect_told(lost.reasons);
}

TEST(Belief, EndsWhereRecordingsDrift) {
    Measurements drifting;
    drifting.readings.resize(10);
    drifting.remarks = {{.kind = Remark::Kind::drift,
                         .outcome = Remark::Outcome::found,
                         .quantity = "torque",
                         .files = {"a.csv"},
                         .lines = {{1, 200}},
                         .count = 4,
                         .of = 10,
                         .size = 0.001,
                         .relative = 0.14,
                         .p = 1e-5}};
    EXPECT_FALSE(belief(agreement(22, 22), fit_at(0.1), drifting).believable());
    drifting.remarks.front().kind = Remark::Kind::wobble;  // averages out
    drifting.remarks.front().period = 1;
    EXPECT_TRUE(belief(agreement(22, 22), fit_at(0.1), drifting).believable());
}

}  // namespace analysis_believable_test
