// The fitter on the 27 nonlinear regressions that NIST has certified to eleven digits, from both
// published starts. Each test prints its row of the table in docs/validation.md.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <iostream>

#include "strd.h"

using namespace pendular;

class Certified : public testing::TestWithParam<std::string> {};

// Derivatives are exact, so that only rounding is between the fit and what is certified; it costs
// most in ENSO (two digits of the parameters) and Lanczos1 (four of the standard deviations, as its
// residuals are 1e-13). A digit more is left for other compilers.
TEST_P(Certified, IsReachedFromBothStarts) {
    const strd::DataSet set = strd::data_set(GetParam());
    std::string row = fmt::format("| {} | {} |", set.name, set.y.size());
    for (const Eigen::VectorXd& start : set.start) {
        const strd::FormulaModel model(set);
        const Fit result = fit(model, set.measured, start);
        const double parameters = strd::fewest_digits(result.parameters, set.certified);
        const double deviations =
            strd::fewest_digits(strd::standard_deviations(result), set.standard_deviation);
        EXPECT_TRUE(result.converged) << result.message;
        EXPECT_GE(parameters, 8);
        EXPECT_GE(deviations, 6);
        EXPECT_GE(strd::digits(result.chi2, set.residual_sum), 6);
        EXPECT_GE(strd::digits(std::sqrt(result.chi2 / result.dof), set.residual_deviation), 6);
        row += fmt::format(" {:.1f} | {:.1f} | {} |", parameters, deviations, model.evaluations);
    }
    std::cout << row << '\n';
}
INSTANTIATE_TEST_SUITE_P(Strd, Certified, testing::ValuesIn(strd::names()),
                         [](const auto& name) { return name.param; });

TEST(RivalLaws, OfOneDataSetKeepTheirOrder) {
    // Misra1a to d are four laws for the same readings.
    const std::pair<const char*, double> order[] = {
        {"Misra1c", 0.04097}, {"Misra1d", 0.05642}, {"Misra1b", 0.07546}, {"Misra1a", 0.12455}};
    double before = 0;
    for (const auto& [name, certified] : order) {
        const strd::DataSet set = strd::data_set(name);
        const double chi2 = fit(strd::FormulaModel(set), set.measured, set.start[0]).chi2;
        EXPECT_NEAR(chi2, certified, 5e-6) << name;
        EXPECT_GT(chi2, before) << name;
        before = chi2;
    }
}
