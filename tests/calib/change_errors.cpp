// Errors of what an effect changes, from a model inside whose errors are known: two smooth
// functions of the condition with random factors. The change is then differentiated by those
// factors.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "calib/model/effect_model.h"
#include "calib/model/emulated_simulation.h"
#include "data/annular_cell.h"
#include "tests/support/emulator_support.h"
#include "tests/support/known_flow.h"

namespace pendular::calib_change_errors_test {

constexpr double size = 1e-3;  ///< standard deviation of the factors

class Uncertain : public Known<FlowPredictor> {
  public:
    Uncertain() : Known({{.name = "friction", .upper = 1}}) {}
    Eigen::Vector2d factors = Eigen::Vector2d::Zero();

    Prediction predict_flow(const Eigen::VectorXd& parameters,
                            const std::vector<EffectiveCondition>& conditions,
                            PredictionPart /*what*/) const override {
        const auto n = 2 * static_cast<Eigen::Index>(conditions.size());
        Prediction result{Eigen::VectorXd(n), Eigen::MatrixXd(n, 1), {}, {}};
        Eigen::MatrixXd by_factor(n, 2);
        for (Eigen::Index k = 0; k < n; k += 2) {
            const Condition& c = conditions[static_cast<std::size_t>(k / 2)];
            const double stress = c.normal_stress, x = std::log(stress / 1000);
            by_factor.row(k) << stress * (1 + 10 * c.inertial_number), stress * x;
            by_factor.row(k + 1) << 0.1, -0.2 * x;
            const double ratio = 0.2 + parameters(0) + std::sqrt(c.inertial_number);
            result.value.segment<2>(k) << ratio * stress, 0.62 - c.inertial_number;
            result.jacobian.block<2, 1>(k, 0) << stress, 0;
        }
        result.value += by_factor * factors;
        result.covariance = result.run_noise = size * size * by_factor * by_factor.transpose();
        return result;
    }
};

class ErrorsOfChanges : public testing::TestWithParam<std::pair<const char*, double>> {};

TEST_P(ErrorsOfChanges, AreThoseOfTheModelInside) {
    const auto [name, amplitude] = GetParam();
    Study study;
    study.grains = {.diameter = 500e-6, .density = 1050};
    study.cell = AnnularCell{21e-3, 45e-3, 60e-3 / 1050};
    std::vector<Condition> conditions;
    for (const double stress : {300.0, 1000.0, 3000.0}) {
        conditions.push_back({.normal_stress = stress,
                              .inertial_number = 0.01,
                              .height = height(0.6, *study.cell),
                              .bead_volume = study.cell->bead_volume});
    }
    const auto inside = std::make_shared<Uncertain>();
    const EffectModel plain(inside, study, {}), with_it(inside, study, {&built_in_effect(name)});
    const Eigen::VectorXd at = Eigen::VectorXd::Constant(1, 0.1),
                          at_too = Eigen::Vector2d(0.1, amplitude);
    const auto errors = with_it.change_errors(at_too, plain, at, conditions);

    Eigen::MatrixXd change_by_factor(6, 2), plain_by_factor(6, 2);
    for (const Eigen::Index k : {0, 1}) {
        Eigen::VectorXd change[2], base[2];
        for (const int side : {0, 1}) {
            inside->factors.setZero();
            inside->factors(k) = side == 0 ? -size : size;
            base[side] = plain.predict(at, conditions, PredictionPart::values).value;
            change[side] =
                with_it.predict(at_too, conditions, PredictionPart::values).value - base[side];
        }
        change_by_factor.col(k) = (change[1] - change[0]) / (2 * size);
        plain_by_factor.col(k) = (base[1] - base[0]) / (2 * size);
    }
    const Eigen::MatrixXd own = size * size * change_by_factor * change_by_factor.transpose(),
                          shared = size * size * plain_by_factor * change_by_factor.transpose();
    ASSERT_GT(own.norm(), 0);
    EXPECT_LT((errors.change - own).norm(), 1e-3 * own.norm()) << name;
    EXPECT_LT((errors.with_without - shared).norm(), 1e-3 * shared.norm()) << name;
}

INSTANTIATE_TEST_SUITE_P(OfInstruments, ErrorsOfChanges,
                         testing::Values(std::pair("torque-gain", 1.2),
                                         std::pair("normal-force-offset", 0.3),
                                         std::pair("lid-slip", 0.4)));

TEST(ErrorsOfChangesByGrains, AreThoseOfTheEmulator) {
    Study study;
    study.grains = {.diameter = 500e-6, .density = 1050};
    const auto simulation = std::make_shared<const EmulatedSimulation>(
        study, fidelity_named("quick"), Emulator(all_shipped_runs(), shipped_hyperparameters()));
    const EffectModel plain(simulation, study, {}),
        with_it(simulation, study, {&built_in_effect("rolling-resistance")});
    const Condition condition{.normal_stress = 1000, .inertial_number = 0.01};
    const auto errors = with_it.change_errors(Eigen::Vector2d(0.4, 0.2), plain,
                                              Eigen::VectorXd::Constant(1, 0.4), {condition});
    const FlowState without{0.4, 0.01};
    FlowState with = without;
    with.effects = {{"rolling-resistance", {0.2}}};
    const Eigen::MatrixXd covariance = simulation->emulator().covariance(
        {{without, dem::Observable::stress_ratio}, {with, dem::Observable::stress_ratio}});
    const double unit = 1000.0 * 1000.0;  // of the squared shear stress, in Pa^2
    EXPECT_NEAR(errors.change(0, 0) / unit,
                covariance(0, 0) + covariance(1, 1) - 2 * covariance(0, 1), 1e-9);
    // Runs with the effect correct the error of the prediction without it.
    EXPECT_NEAR(errors.with_without(0, 0) / unit, covariance(0, 1) - covariance(0, 0), 1e-9);
    EXPECT_LT(errors.with_without(0, 0), -0.1 * unit * covariance(0, 0));
}

}  // namespace pendular::calib_change_errors_test
