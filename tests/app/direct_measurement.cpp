// Effects measured by themselves: how a study states them, what a model says of them, and what they
// are worth in a fit and a diagnosis.
#include "calib/fit/calibrate_study.h"
#include "sim/catalogue/resolved_study.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "analysis/diagnosis/evidence.h"
#include "analysis/left_out.h"
#include "analysis/misfit/compare.h"
#include "calib/fit/calibration.h"
#include "data/input_error.h"
#include "data/study/study.h"
#include "reports/tables.h"
#include "tests/support/app_support.h"
#include "tests/support/golden.h"
#include "tests/support/known_flow.h"

namespace pendular::direct_measurement_test {

/// A study with these entries.
Study study_with(const TemporaryFolder& folder, const std::string& entries) {
    std::ofstream(folder.path() / "points.csv")
        << "normal_stress [Pa],shear_stress [Pa],shear_stress_sd [Pa],solid_fraction [1],"
           "solid_fraction_sd [1],inertial_number [1],liquid_content [1]\n"
           "300,79.1,0.8,0.6189,0.0012,0.003,0\n"
           "1000,258.0,2.6,0.6198,0.0012,0.003,0\n"
           "3000,766.0,7.7,0.6203,0.0012,0.003,0\n";
    std::ofstream(folder.path() / "study.toml")
        << grains_table << cell_table()
        << "[liquid]\nsurface_tension = \"20 mN/m\"\ncontact_angle = \"0 deg\"\n"
        << points_table << entries;
    return read_study(folder.path());
}

std::vector<DirectMeasurement> measured(const std::string& entries) {
    const TemporaryFolder folder;
    const Study study = study_with(folder, entries);
    return direct_measurements(study, EffectCatalogue(study));
}

std::string refusal(const std::string& entries) {
    try {
        measured(entries);
    } catch (const InputError& error) {
        return error.what();
    }
    return "accepted";
}

TEST(DirectMeasurement, IsReadInTheUnitOfItsEffect) {
    const auto direct = measured(
        "[[direct]]\neffect = \"torque-offset\"\nvalue = \"0.42 mN m\"\nerror = \"50 uN m\"\n"
        "[[direct]]\neffect = \"bead-loss\"\nvalue = 0.002\nerror = \"0.1 %\"\n"
        "[[direct]]\neffect = \"capillary-bridges\"\nvalue = \"21 mN/m\"\nerror = \"1 mN/m\"\n");
    ASSERT_EQ(direct.size(), 3u);
    EXPECT_EQ(direct[0].parameter, "torque-offset.torque");
    EXPECT_DOUBLE_EQ(direct[0].value, 0.42e-3);
    EXPECT_DOUBLE_EQ(direct[0].standard_error, 5e-5);
    EXPECT_EQ(direct[0].neutral, 0);
    expect_told({direct[0].by});
    EXPECT_EQ(direct[1].value, 0.002);
    EXPECT_DOUBLE_EQ(direct[1].standard_error, 0.001);
    // On in any case: what the study gives is what a model without it says.
    EXPECT_DOUBLE_EQ(direct[2].neutral, 0.02);
}

TEST(DirectMeasurement, IsRefusedWithTheWayOut) {
    expect_told(
        {refusal("[[direct]]\neffect = \"torque-ofset\"\nvalue = \"1 mN m\"\n"
                 "error = \"1 mN m\"\n"),
         refusal("[[direct]]\neffect = \"torque-offset\"\nvalue = \"1 N\"\n"
                 "error = \"1 mN m\"\n"),
         refusal("[[direct]]\neffect = \"torque-offset\"\nvalue = \"1 mN m\"\n"
                 "error = \"0 mN m\"\n"),
         refusal("[[direct]]\neffect = \"torque-offset\"\nerror = \"1 mN m\"\n"),
         refusal("[[direct]]\neffect = \"torque-offset\"\nvalue = \"\"\nerror = \"1 mN m\"\n"),
         refusal("[[direct]]\neffect = \"grain-weight\"\nvalue = 1\nerror = 1\n"),
         refusal("[direct]\neffect = \"torque-offset\"\n")});
}

/// Shear stress theta s22, solid fraction 0.6.
class Line : public KnownFlow {
  public:
    explicit Line(const std::string& parameter) : KnownFlow({{.name = parameter, .upper = 1}}) {}
    Prediction predict(const Eigen::VectorXd& parameters, const std::vector<Condition>& conditions,
                       PredictionPart /*what*/) const override {
        const auto n = 2 * static_cast<Eigen::Index>(conditions.size());
        Prediction result{Eigen::VectorXd::Constant(n, 0.6), Eigen::MatrixXd::Zero(n, 1),
                          Eigen::MatrixXd::Zero(n, n), Eigen::MatrixXd::Zero(n, n)};
        for (std::size_t k = 0; k < conditions.size(); ++k) {
            const auto entry = 2 * static_cast<Eigen::Index>(k);
            result.value(entry) = parameters(0) * conditions[k].normal_stress;
            result.jacobian(entry, 0) = conditions[k].normal_stress;
        }
        return result;
    }
};

Reading reading(double shear_stress, double error) {
    Reading result{.condition = {.normal_stress = 100, .inertial_number = 0.01}};
    result.value << shear_stress, 0.6;
    result.covariance = Eigen::Vector2d(error * error, 1e-6).asDiagonal();
    return result;
}

const std::vector<DirectMeasurement> two = {
    {.parameter = "friction", .unit = "1", .value = 0.34, .standard_error = 0.02},
    {.parameter = "other", .unit = "1", .neutral = 2, .value = 2.3, .standard_error = 0.1}};

TEST(DirectMeasurement, WeighsInAFitByItsError) {
    const auto line = std::make_shared<Line>("friction");
    const ModelOfReadings model(line, {reading(30, 1).condition}, two);
    const Fit best = fit(model, stack({reading(30, 1)}, two), Eigen::VectorXd::Constant(1, 0.2));
    // 0.30(1) and 0.34(2).
    EXPECT_NEAR(best.parameters(0), 0.308, 1e-9);
    EXPECT_NEAR(best.standard_error(0), 0.01 / std::sqrt(1.25), 1e-9);
    EXPECT_EQ(best.dof, 2 + 2 - 1);
    // Where a model has no such parameter it says neutral: 0.3 off with an error of 0.1.
    EXPECT_NEAR(best.chi2, 0.64 + 2.56 + 9, 1e-6);
    EXPECT_DOUBLE_EQ(model.predict(best.parameters).value(3), 2);
}

TEST(DirectMeasurement, IsInTheErrorsOfPredictions) {
    // 0.30(1) and 0.34(2) make an error of 0.01/sqrt(1.25), whichever of them it comes from.
    const auto line = std::make_shared<Line>("friction");
    Calibration c{.readings = {reading(30, 1)}, .fitted = 1, .direct = {two[0]}};
    const ModelOfReadings model(line, {c.readings[0].condition}, c.direct);
    c.parameters = model.parameters();
    c.fit = fit(model, stack(c.readings, c.direct), Eigen::VectorXd::Constant(1, 0.2));
    const Prediction there =
        predict_unseen(*line, c, {{.normal_stress = 1000, .inertial_number = 0.01}});
    EXPECT_NEAR(std::sqrt(there.covariance(0, 0)), 1000 * 0.01 / std::sqrt(1.25), 1e-6);
}

TEST(DirectMeasurement, CountsInAComparison) {
    const auto line = std::make_shared<Line>("friction");
    Calibration c{.readings = {reading(30, 1), reading(31, 1)}, .fitted = 2, .direct = two};
    c.parameters = line->parameters();
    c.fit.parameters = Eigen::VectorXd::Constant(1, 0.3);
    c.prediction =
        line->predict(c.fit.parameters, {c.readings[0].condition, c.readings[1].condition},
                      PredictionPart::covariance);
    const Comparison comparison = compare(c);
    // 31 for 30, 0.34(2) for 0.3, 2.3(1) for 2.
    EXPECT_NEAR(comparison.total.chi2, 1 + 4 + 9, 1e-9);
    EXPECT_NEAR(comparison.fitted.chi2, 14, 1e-9);
    EXPECT_EQ(comparison.total.dof, 4 + 2 - 1);
    ASSERT_EQ(comparison.direct.size(), 2u);
    EXPECT_NEAR(comparison.direct[1].normalised(), 3, 1e-9);
    expect_told(predictions_table(comparison));
}

TEST(DirectMeasurement, HoldsWhereAConditionIsLeftOut) {
    // Without the only condition at which the friction counts, the sled still knows it.
    const auto line = std::make_shared<Line>("friction");
    Calibration c{.readings = {reading(30, 1), reading(3000, 1)},
                  .fitted = 2,
                  .direct = {{.parameter = "friction", .value = 0.3, .standard_error = 1e-5}}};
    c.readings[1].condition.normal_stress = 1e4;
    c.readings[0].value(0) = 60;  // wrong by a factor of two
    c.parameters = line->parameters();
    c.fit.parameters = Eigen::VectorXd::Constant(1, 0.3);
    Calibration without = c;
    without.direct.clear();
    EXPECT_GT(left_out_errors(line, without)->rms_percent[0], 60)
        << "the wrong reading alone foretells the other";
    EXPECT_LT(left_out_errors(line, c)->rms_percent[0], 40);
}

TEST(DirectMeasurement, IsAnEntryOfItsOwnInADiagnosis) {
    std::vector<DirectMeasurement> direct = two;
    direct[1].value = 0;  // nothing of the other was found: that counts too
    const std::vector<Reading> readings = {reading(30, 1), reading(31, 1)};
    const Evidence evidence = evidence_of(readings, {}, direct);
    ASSERT_EQ(evidence.measured.value.size(), 6);
    EXPECT_EQ(evidence.measured.value(5), 0);
    EXPECT_DOUBLE_EQ(evidence.measured.covariance(4, 4), 0.0004);
    EXPECT_THAT(evidence.conditions, testing::IsSupersetOf({std::vector<Eigen::Index>{4},
                                                            std::vector<Eigen::Index>{5}}));
    EXPECT_EQ(evidence.suspects.back().name, "the direct measurements of other");
    EXPECT_GT(evidence.suspects.back().columns(5, 0), 0);
    // Several of one parameter are off together, by the same amount.
    direct[1].parameter = "friction";
    const Evidence of_one = evidence_of(readings, {}, direct);
    EXPECT_EQ(of_one.suspects.size(), evidence.suspects.size() - 1);
    EXPECT_GT(of_one.suspects.back().columns(4, 0), 0);
    EXPECT_EQ(of_one.suspects.back().columns(4, 0), of_one.suspects.back().columns(5, 0));
    direct[1].parameter = "other";

    const auto line = std::make_shared<Line>("friction");
    const ModelOfReadings model(line, {readings[0].condition, readings[1].condition}, direct);
    const WeightedResiduals residuals(evidence.measured,
                                      model.predict(Eigen::VectorXd::Constant(1, 0.305)));
    // Lack of fit sees 20 standard errors of it.
    const Eigen::MatrixXd means = residuals.means_over(evidence.conditions);
    EXPECT_GT((means.transpose() * residuals.residuals()).squaredNorm(), 399);
}

TEST(DirectMeasurement, CountsOnTheCommandLine) {
    const TemporaryFolder folder;
    const auto diagnosis = [&](const std::string& entries) {
        study_with(folder, entries);
        const Outcome run =
            run_pendular("diagnose " + folder.path().string() + " --quiet --json -");
        EXPECT_EQ(run.code, 0) << run.errors;
        return nlohmann::json::parse(run.output);
    };
    const std::string drag = "[[direct]]\neffect = \"torque-offset\"\nvalue = \"0.1 mN m\"\n",
                      on = "[model]\neffects = [\"torque-offset\"]\n";
    // The readings alone do not see a drag of this size; the empty cell does.
    EXPECT_THAT(diagnosis("").at("verdict"), "inconclusive");
    const auto missing = diagnosis(drag + "error = \"5 uN m\"\n");
    EXPECT_EQ(missing.at("verdict"), "missing");
    EXPECT_THAT(missing.at("effects"), testing::ElementsAre("torque-offset"));
    // And tells its size where it is on.
    const auto added = diagnosis(on + drag + "error = \"5 uN m\"\n");
    EXPECT_EQ(added.at("verdict"), "inconclusive");
    const auto& torque = added.at("parameters").at("torque-offset.torque");
    EXPECT_NEAR(torque.at("value"), 1e-4, 5e-6);
    EXPECT_NEAR(torque.at("stderr"), 5e-6, 1e-6);
    EXPECT_GT(diagnosis(on).at("parameters").at("torque-offset.torque").at("stderr"), 1.5e-5);
}

}  // namespace pendular::direct_measurement_test
