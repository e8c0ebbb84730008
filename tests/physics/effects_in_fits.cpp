// What a fit makes of every effect of the registry: model and truth are the emulator of the atlas,
// so that no simulation is needed; readings scatter as an instrument's do.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/support/effect_study.h"

namespace effects_in_fits_test {

using namespace pendular;

/// Readings of predicted values with 1 % scatter in shear stress and 0.2 % in solid fraction.
Measured readings_of(const Eigen::VectorXd& values, unsigned seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    Measured measured{values, Eigen::MatrixXd::Zero(values.size(), values.size())};
    for (Eigen::Index k = 0; k < values.size(); ++k) {
        const double error = (k % 2 == 0 ? 0.01 : 0.002) * values(k);
        measured.value(k) += error * normal(random);
        measured.covariance(k, k) = error * error;
    }
    return measured;
}

/// Parameters with the effect at three times the smallest effect of interest, within its bounds.
Eigen::VectorXd planted(const Model& model, const Effect& effect) {
    Eigen::VectorXd truth(static_cast<Eigen::Index>(model.parameters().size()));
    truth(0) = planted_friction;
    Eigen::Index next = 1;
    for (const EffectParameter& p : effect.parameters) {
        if (p.is_fitted()) {
            truth(next++) =
                effect.given_by_liquid
                    ? 0.03
                    : std::clamp(p.neutral + 3 * p.smallest_of_interest, p.lower, 0.8 * p.upper);
        }
    }
    return truth;
}

std::string test_name(const testing::TestParamInfo<std::string>& test) {
    std::string name = test.param;
    std::ranges::replace(name, '-', '_');
    return name;
}

/// Effects that act on readings of base `dem`.
std::vector<std::string> effects_of_dem() {
    std::vector<std::string> names;
    for (const Effect& effect : built_in_effects()) {
        if (!effect.of_closure()) {
            names.push_back(effect.name);
        }
    }
    return names;
}

class OfEveryEffect : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Registry, OfEveryEffect, testing::ValuesIn(effects_of_dem()), test_name);

/// The simulation's own errors are left out of the weights: truth and model share them.
TEST_P(OfEveryEffect, FitRecoversAPlantedValue) {
    const Effect& effect = built_in_effect(GetParam());
    ASSERT_TRUE(predictable(effect)) << "the atlas has no run with it";
    const ModelOfReadings model = laboratory().with({&effect});
    const ModelOfReadings without = laboratory().with({});
    const Eigen::VectorXd truth = planted(model, effect);
    const Measured measured = readings_of(model.predict(truth, PredictionPart::slopes).value, 11);
    const Fit with_it = fit(model, measured, start_of(model));
    const Fit without_it = fit(without, measured, start_of(without));
    EXPECT_TRUE(with_it.converged) << with_it.message;
    // 60 values: chi2 exceeds 100 with probability 1e-3 where the model is right. The simulation's
    // covariance is part of the weights, so that it is less here.
    EXPECT_LT(with_it.chi2, 100);
    for (Eigen::Index k = 0; k < truth.size(); ++k) {
        EXPECT_LT(std::abs(with_it.parameters(k) - truth(k)), 4 * with_it.standard_error(k))
            << model.parameters()[static_cast<std::size_t>(k)].name << " = "
            << with_it.parameters(k) << ", planted " << truth(k);
    }
    // With it the readings are described at least as well; a wrong sign would not be.
    EXPECT_LT(with_it.chi2, without_it.chi2 + 1);
    RecordProperty("chi2_without", std::to_string(without_it.chi2));
}

TEST_P(OfEveryEffect, DerivativesAreThoseOfThePrediction) {
    const Effect& effect = built_in_effect(GetParam());
    ASSERT_TRUE(predictable(effect)) << "the atlas has no run with it";
    const ModelOfReadings model = laboratory().with({&effect});
    const Eigen::VectorXd at = planted(model, effect);
    const Prediction there = model.predict(at, PredictionPart::slopes);
    for (Eigen::Index k = 0; k < at.size(); ++k) {
        const double step = 3e-3 * std::max(std::abs(at(k)), 1e-6);
        Eigen::VectorXd above = at, below = at;
        above(k) += step, below(k) -= step;
        const Eigen::VectorXd slope = (model.predict(above, PredictionPart::slopes).value -
                                       model.predict(below, PredictionPart::slopes).value) /
                                      (2 * step);
        const double scale = slope.cwiseAbs().maxCoeff();
        EXPECT_GT(scale, 0) << "nothing depends on "
                            << model.parameters()[static_cast<std::size_t>(k)].name;
        EXPECT_LT((slope - there.jacobian.col(k)).cwiseAbs().maxCoeff(), 0.02 * scale)
            << model.parameters()[static_cast<std::size_t>(k)].name;
    }
}

TEST(CapillaryShearStress, TakesFromRumpfsStrengthMostAtLittleLiquid) {
    Laboratory plain("rumpf"), full("rumpf", closures::Level::strength2), truth("dem");
    const Eigen::VectorXd at = Eigen::VectorXd::Constant(1, planted_friction);
    const Eigen::VectorXd without = plain.with({}).predict(at, PredictionPart::slopes).value,
                          with_it = full.with({}).predict(at, PredictionPart::slopes).value,
                          simulated = truth.with({}).predict(at, PredictionPart::slopes).value;
    double worst_without = 0, worst_with = 0;
    const auto all = conditions();
    for (std::size_t k = 0; k < all.size(); ++k) {
        const auto row = 2 * static_cast<Eigen::Index>(k);
        if (all[k].dry()) {
            EXPECT_EQ(with_it(row), without(row));
            continue;
        }
        worst_without = std::max(worst_without, without(row) / simulated(row) - 1);
        worst_with = std::max(worst_with, std::abs(with_it(row) / simulated(row) - 1));
    }
    // Badetti et al. (2018): up to 20 to 30 % too high without, good everywhere with it; I = 0.03
    // and the pressures here are beyond theirs.
    EXPECT_GT(worst_without, 0.10);
    EXPECT_LT(worst_with, 0.10);
    RecordProperty("worst_without", std::to_string(worst_without));
    RecordProperty("worst_with", std::to_string(worst_with));
}

TEST(EffectModel, WithoutEffectsIsTheModelInsideBitForBit) {
    const ModelOfReadings model = laboratory().with({});
    const Study study = study_with("dem");
    const Fidelity quick = fidelity_named("quick");
    KnownRuns known{runs_serving(study, quick, shipped_runs()), shipped_hyperparameters(), false};
    const EmulatedSimulation inside(study, quick, Emulator(known.runs, known.hyperparameters));
    const Eigen::VectorXd at = Eigen::VectorXd::Constant(1, planted_friction);
    EXPECT_EQ(model.predict(at, PredictionPart::slopes).value,
              inside.predict(at, conditions(), PredictionPart::slopes).value);
    EXPECT_EQ(model.predict(at, PredictionPart::slopes).jacobian,
              inside.predict(at, conditions(), PredictionPart::slopes).jacobian);
}

}  // namespace effects_in_fits_test
