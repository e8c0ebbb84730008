// Switches on a page show what `pendular add` gives: each combination of effects has the numbers of
// the study with these effects, and the expansion about each fit is as exact as it says.
#include "workflow/switched_models.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "calib/fit/measured.h"
#include "tests/support/data_support.h"
#include "workflow/session.h"

namespace switched_models_test {

using namespace pendular;
using testing::ElementsAre;

/// Copy of an example study without results.
class SwitchedModelsTest : public testing::Test {
  protected:
    TemporaryFolder folder;
    std::filesystem::path study = copied_example("hidden-effect", folder);
    SessionOptions options{.fidelity = fidelity_named("standard"), .threads = 2};

    SwitchedModels models(std::size_t most) const {
        const Session session(study, options);
        return switched_models(session.resolved(), session.diagnose(), options, {.most = most});
    }
};

double standard_error(const SwitchedModel& model, Eigen::Index k) {
    return model.calibration.fit.standard_error(k);
}

TEST_F(SwitchedModelsTest, HaveTheNumbersOfTheStudyWithTheirEffects) {
    const SwitchedModels all = models(3);
    ASSERT_THAT(all.switches, ElementsAre("wall-friction", "torque-gain", "polydispersity"));
    EXPECT_EQ(all.current, 0u);
    ASSERT_EQ(all.models.size(), 8u);
    const auto expect_same = [&](std::size_t index, const FittedStudy& fitted) {
        ASSERT_TRUE(all.models[index]) << all.why_not[index];
        const SwitchedModel& model = *all.models[index];
        const Misfit &ours = model.comparison.total, &theirs = fitted.comparison.total;
        EXPECT_NEAR(ours.chi2, theirs.chi2, 1e-3 * theirs.chi2) << index;
        EXPECT_EQ(ours.dof, theirs.dof) << index;
        const Eigen::VectorXd difference =
            model.calibration.fit.parameters - fitted.calibration.fit.parameters;
        for (Eigen::Index k = 0; k < difference.size(); ++k) {
            EXPECT_LE(std::abs(difference(k)), 0.02 * standard_error(model, k)) << index;
        }
    };
    const ChangedStudy first = Session(study, options).add("wall-friction");
    expect_same(0, first.before);
    expect_same(1, first.after);
    // From the usual start, the least chi2 is sought as everywhere else, and not only nearby.
    EXPECT_NEAR(all.models[0]->comparison.total.chi2, first.before.comparison.total.chi2, 1e-6);
    EXPECT_NEAR(all.models[1]->comparison.total.chi2, first.after.comparison.total.chi2, 1e-6);
    const ChangedStudy second = Session(study, options).add("torque-gain");
    expect_same(1 + 2, second.after);
    const SwitchedModels after = models(3);
    EXPECT_THAT(after.switches, ElementsAre("wall-friction", "torque-gain", testing::_));
    EXPECT_EQ(after.current, 3u);
    EXPECT_NEAR(after.models[3]->comparison.total.chi2, second.after.comparison.total.chi2, 0.01);
}

TEST_F(SwitchedModelsTest, KnowHowFarTheirExpansionHolds) {
    const SwitchedModels all = models(2);
    for (const std::optional<SwitchedModel>& each : all.models) {
        ASSERT_TRUE(each);
        const Calibration& c = each->calibration;
        const ModelOfReadings model(each->predictor, conditions_of(c.readings), c.direct);
        const Measured measured = stack(c.readings, c.direct);
        const Eigen::VectorXd tolerance = 0.1 * measured.covariance.diagonal().cwiseSqrt();
        EXPECT_NEAR(each->chi2_form(0, 0), each->comparison.total.chi2, 1e-6);
        // Points inside of the box, which the search for the box did not try.
        for (const double share : {-0.9, -0.5, 0.6, 0.95}) {
            Eigen::VectorXd change = Eigen::VectorXd::Zero(c.fit.parameters.size());
            for (Eigen::Index k = 0; k < change.size(); ++k) {
                const double end = share > 0 ? each->trusted.upper(k) : each->trusted.lower(k);
                change(k) = std::abs(share) * (k % 2 == 0 ? 1 : 0.7) * (end - c.fit.parameters(k));
            }
            const Eigen::VectorXd exact = model.predict(c.fit.parameters + change).value;
            const Eigen::VectorXd off = (exact - each->response.after(change)).cwiseAbs();
            EXPECT_LE(off.cwiseQuotient(tolerance).maxCoeff(), 1.2);
            const Eigen::VectorXd misfit = measured.value - each->response.after(change);
            const Eigen::MatrixXd total =
                measured.covariance + model.predict(c.fit.parameters).covariance;
            const double chi2 = misfit.dot(total.ldlt().solve(misfit));
            Eigen::VectorXd terms(each->chi2_form.rows());
            terms << 1, change, products(change);
            EXPECT_NEAR(terms.dot(each->chi2_form * terms), chi2, 1e-6 * chi2);
        }
        EXPECT_GT(each->trusted.upper(0) - each->trusted.lower(0), standard_error(*each, 0));
    }
}

TEST_F(SwitchedModelsTest, SayWhatLeavingOutAReadingDoes) {
    const SwitchedModels all = models(1);
    const SwitchedModel& model = *all.models[1];
    const Calibration& c = model.calibration;
    ASSERT_EQ(model.without_each.rows(), static_cast<Eigen::Index>(c.fitted));
    const std::size_t left_out = 5;
    std::vector<Reading> rest = c.readings;
    rest.erase(rest.begin() + left_out);
    const ModelOfReadings of_rest(model.predictor, conditions_of(rest), c.direct);
    const Fit refitted = fit(of_rest, stack(rest, c.direct), c.fit.parameters);
    EXPECT_NEAR(c.fit.chi2 - refitted.chi2, model.without_each(left_out, 0), 0.02);
    for (Eigen::Index k = 0; k < refitted.parameters.size(); ++k) {
        EXPECT_NEAR(refitted.parameters(k) - c.fit.parameters(k),
                    model.without_each(left_out, 1 + k), 0.05 * standard_error(model, k));
    }
}

}  // namespace switched_models_test
