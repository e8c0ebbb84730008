// Models of wet grains by formulas: the levels of the ladder from a straight line to the
// simulation.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <tuple>

#include "calib/model/closure_model.h"
#include "calib/model/mohr_coulomb.h"
#include "calib/model/run_planner.h"
#include "data/input_error.h"
#include "tests/support/emulator_support.h"
#include "tests/support/known_flow.h"
#include "tests/support/small_wet_study.h"

namespace calib_closure_models_test {

using namespace pendular;
using namespace small_wet;

std::shared_ptr<const EmulatedSimulation> planned(const Study& study,
                                                  const std::vector<Condition>& conditions) {
    RunPlanner planner(study, conditions, tiny, 1, {.threads = 2}, {{}, shipped_hyperparameters()});
    planner.improve(0.2, without_effects(conditions), 1);
    return planner.simulation();
}

Study with_planted_strengths(const Study& study) {
    Study with = study;
    with.model.base = "mohr-coulomb";
    for (const auto& [pressure, content, ratio] :
         {std::tuple{2.5, 0.03, 0.55}, {8.0, 0.03, 0.43}, {1.0, 0.03, 0.6}, {4.0, 0.01, 0.45}}) {
        with.model.strengths.push_back({condition(pressure, content), ratio, 0.01 * ratio});
    }
    return with;
}

TEST(ClosureModels, HaveDerivativesOfTheirOwnWetPredictions) {
    const std::vector<Condition> conditions = {condition(2.5, 0.03), condition(8, 0.01),
                                               condition(8, 0)};
    const auto simulation = planned(wet_study(), conditions);
    std::vector<std::shared_ptr<const Predictor>> models = {
        simulation,
        std::make_shared<MohrCoulombModel>(simulation, with_planted_strengths(wet_study()))};
    using closures::Level;
    for (const Level level : {Level::rumpf, Level::strength3, Level::strength2, Level::strength1}) {
        models.push_back(std::make_shared<ClosureModel>(simulation, wet_study(), level));
    }
    for (const auto& model : models) {
        const double d = 1e-4;
        const auto value = [&](double by) {
            return model->predict(at(0.2 + by), conditions).value;
        };
        const Eigen::VectorXd numeric = (value(d) - value(-d)) / (2 * d);
        EXPECT_LT((numeric - model->predict(at(0.2), conditions).jacobian.col(0)).norm(),
                  1e-3 * numeric.norm());
    }
}

TEST(ClosureModel, IsTheDryLawWithRumpfsCohesion) {
    const Study study = wet_study();
    const Condition wet = condition(2.5, 0.03);
    Condition dry = wet;
    dry.liquid_content = 0;
    const auto simulation = planned(study, {wet, dry});
    const ClosureModel rumpf(simulation, study, closures::Level::strength3);
    const Prediction by_rumpf = rumpf.predict(at(0.2), {wet, dry}),
                     simulated = simulation->predict(at(0.2), {wet, dry});
    const double z = simulation->effective_coordination(0.2, wet).value;
    EXPECT_NEAR(by_rumpf.value(0),
                simulated.value(2) * (1 + simulated.value(1) * z / (std::numbers::pi * 2.5)), 1e-9);
    EXPECT_EQ(by_rumpf.value(1), simulated.value(1));
    EXPECT_EQ(by_rumpf.value(2), simulated.value(2));
    EXPECT_GT(by_rumpf.covariance(0, 0), 0);
    EXPECT_GT(z, 5);
    EXPECT_LT(z, 8);
}

// Each level is the formula of Badetti et al. (2018) that its name says, from what is emulated.
TEST(ClosureModel, ClimbsFromRumpfToTheCapillaryStresses) {
    using closures::Level;
    const Study study = wet_study();
    const Condition wet = condition(2.5, 0.03);
    Condition dry = wet;
    dry.liquid_content = 0;
    const auto simulation = planned(study, {wet, dry});
    const auto ratio = [&](Level level) {
        return ClosureModel(simulation, study, level).predict(at(0.2), {wet}).value(0) /
               wet.normal_stress;
    };
    const double law = simulation->predict(at(0.2), {dry}).value(0) / dry.normal_stress,
                 fraction = simulation->predict(at(0.2), {wet}).value(1), pressure = 2.5,
                 z = simulation->approximate_coordination(0.2, wet).value,
                 shear = simulation->capillary_shear_stress(0.2, wet).value,
                 normal = simulation->capillary_normal_stress(0.2, wet).value;
    EXPECT_NEAR(ratio(Level::rumpf), law * (1 + fraction * z / (std::numbers::pi * pressure)),
                1e-9);
    EXPECT_NEAR(ratio(Level::strength3) - ratio(Level::strength2), shear / pressure, 1e-9);
    EXPECT_NEAR(ratio(Level::strength1), law * (1 - normal / pressure) - shear / pressure, 1e-9);
    EXPECT_GT(z, 5);
    EXPECT_GT(shear, 0);
    EXPECT_LT(normal, -0.5);
}

TEST(MohrCoulombModel, IsTheStraightLineThroughItsStrengths) {
    const Study study = with_planted_strengths(wet_study());
    const std::vector<Condition> conditions = {condition(2.5, 0.03), condition(8, 0.03),
                                               condition(1, 0.03), condition(4, 0.01),
                                               condition(5, 0.0101)};
    const auto simulation = planned(wet_study(), conditions);
    const MohrCoulombModel model(simulation, study);
    const auto cohesions = model.cohesions(0.2);
    ASSERT_EQ(cohesions.size(), 2u);
    EXPECT_NEAR(cohesions[0].first, 0.01, 1e-12);
    EXPECT_NEAR(cohesions[1].first, 0.03, 1e-12);
    const auto law = [&](Condition c) {
        c.liquid_content = 0;
        return simulation->predict(at(0.2), {c}).value(0) / c.normal_stress;
    };
    // One strength: the line goes through it. Two: by hand; the third is below P* = 2.3.
    EXPECT_NEAR(cohesions[0].second, 4 * (0.45 - law(conditions[3])), 1e-9);
    const double w1 = 1 / std::pow(0.0055 * 2.5, 2), w2 = 1 / std::pow(0.0043 * 8, 2);
    EXPECT_NEAR(
        cohesions[1].second,
        (w1 * 2.5 * (0.55 - law(conditions[0])) + w2 * 8 * (0.43 - law(conditions[1]))) / (w1 + w2),
        1e-9);
    const Prediction predicted = model.predict(at(0.2), conditions),
                     simulated = simulation->predict(at(0.2), conditions);
    for (const std::size_t k : {0u, 1u, 2u}) {
        const Condition& c = conditions[k];
        const double pressure = c.normal_stress / conditions[2].normal_stress;
        EXPECT_NEAR(predicted.value(2 * static_cast<Eigen::Index>(k)) / c.normal_stress,
                    law(c) + cohesions[1].second / pressure, 1e-9);
    }
    EXPECT_EQ(predicted.value(5), simulated.value(5)) << "solid fractions are simulated";
    // Beside the content that was fitted, and below the line: the cohesion's own error counts.
    const double error =
        0.0055 * 2.5 * 0.0043 * 8 / std::hypot(0.0055 * 2.5, 0.0043 * 8);  // of c* at 0.03
    EXPECT_GT(predicted.covariance(4, 4), std::pow(error * conditions[2].normal_stress, 2));
    EXPECT_GT(predicted.covariance(8, 8),
              std::pow(0.0045 * 4 / 5 * conditions[4].normal_stress, 2));
    EXPECT_EQ(fitted_cohesions(study.model, study.grains, study.liquid), 2);
    EXPECT_EQ(fitted_cohesions(wet_study().model, study.grains, study.liquid), 0);
}

TEST(MohrCoulombModel, AddsNoErrorOfItsCohesionToADifferenceOfInertialNumbers) {
    const Study study = with_planted_strengths(wet_study());
    Condition fitted = condition(8, 0.03), faster = fitted;
    faster.inertial_number *= 2;
    const auto simulation = planned(wet_study(), {fitted, faster, condition(4, 0.01)});
    // The variance of the difference of the two shear stresses.
    const auto variance = [](const Prediction& p) {
        return p.covariance(0, 0) + p.covariance(2, 2) - 2 * p.covariance(0, 2);
    };
    Condition dry = fitted, dry_faster = faster;
    dry.liquid_content = dry_faster.liquid_content = 0;
    const double expected = variance(simulation->predict(at(0.2), {dry, dry_faster}));
    const Prediction wet = MohrCoulombModel(simulation, study).predict(at(0.2), {fitted, faster});
    EXPECT_NEAR(variance(wet), expected, 1e-6 * expected);
}

TEST(MohrCoulombModel, FitsSteadyShearAlone) {
    Study study = wet_study();
    study.model.base = "mohr-coulomb";
    Reading steady, failure, dry;
    steady.condition = condition(4, 0.03);
    steady.value = {0.4 * steady.condition.normal_stress, 0.6};
    steady.covariance(0, 0) = std::pow(0.01 * steady.condition.normal_stress, 2);
    failure = steady;
    failure.condition.at_failure = true;
    dry = steady;
    dry.condition.liquid_content = 0;
    const Study with = with_strengths(study, {failure, steady, dry});
    ASSERT_EQ(with.model.strengths.size(), 1u);
    EXPECT_FALSE(with.model.strengths[0].condition.at_failure);
    EXPECT_NEAR(with.model.strengths[0].stress_ratio, 0.4, 1e-12);
    EXPECT_NEAR(with.model.strengths[0].standard_error, 0.01, 1e-12);
    study.model.base = "dem";
    EXPECT_TRUE(with_strengths(study, {steady}).model.strengths.empty());
}

TEST(MohrCoulombModel, NeedsStrengthsAtLargePressures) {
    Study study = with_planted_strengths(wet_study());
    const auto simulation = planned(wet_study(), {condition(2.5, 0.03), condition(2.5, 0)});
    std::erase_if(study.model.strengths, [](const MeasuredStrength& strength) {
        return strength.condition.normal_stress > condition(2, 0.03).normal_stress;
    });
    EXPECT_THROW(MohrCoulombModel(simulation, study), InputError);
}

}  // namespace calib_closure_models_test
