// Figures of all effects of a diagnosis: reductions of chi2, and similarity of the changes.
#include "reports/diagnosis_figures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/linear_space.h"

namespace pendular::scan_figures_test {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

const LinearSpace space(Eigen::MatrixXd::Ones(2, 1), {{"gain", Eigen::Vector2d(1, 0)},
                                                      {"offset", Eigen::Vector2d(3, 4)},
                                                      {"unseen", Eigen::Vector2d(0, 0)}});

/// Finding on a candidate whose whitened change has this direction, without length: not seen.
Finding finding(std::size_t candidate, const Eigen::Vector2d& direction, double reduction) {
    Finding result{.candidate = candidate};
    if (direction.norm() > 0) result.test.basis = direction.normalized();
    result.test.predicted_reduction = reduction;
    return result;
}

Diagnosis diagnosis(double chi2) {
    Diagnosis d;
    d.base.fit.chi2 = chi2, d.dof = 10;
    d.scan = {finding(0, {1, 0}, 50), finding(1, {3, -4}, 20), finding(2, {0, 0}, 0)};
    d.scan[0].refitted_reduction = 60;
    return d;
}

TEST(ScanFigures, ShowPredictedAndRefittedReductions) {
    const auto figures = scan_figures(diagnosis(100), space);
    ASSERT_THAT(figures, SizeIs(2));
    const Panel& panel = figures[0].panels.at(0);
    EXPECT_THAT(panel.y_names, ElementsAre("offset", "gain"));  // the largest at the top
    ASSERT_THAT(panel.curves, SizeIs(2));
    EXPECT_THAT(panel.curves[0].x, ElementsAre(20, 50));
    EXPECT_THAT(panel.curves[1].x, ElementsAre(60));
    EXPECT_THAT(panel.references, SizeIs(1));
}

TEST(ScanFigures, ShowTheLargestReductionsOfMany) {
    std::vector<LinearSpace::Column> columns;
    Diagnosis many;
    many.base.fit.chi2 = 100, many.dof = 10;
    for (std::size_t k = 0; k < 25; ++k) {
        columns.push_back({"effect-" + std::to_string(k), Eigen::Vector2d(1, 0)});
        many.scan.push_back(finding(k, {1, 0}, static_cast<double>(k)));
    }
    const LinearSpace all(Eigen::MatrixXd::Ones(2, 1), columns);
    const Panel panel = scan_figures(many, all)[0].panels.at(0);
    ASSERT_THAT(panel.y_names, SizeIs(20));
    EXPECT_EQ(panel.y_names.back(), "effect-24");
    EXPECT_EQ(panel.y_names.front(), "effect-5");
}

TEST(ScanFigures, LeaveOutTheLineOfChi2ThatWouldSqueezeTheBars) {
    const auto figures = scan_figures(diagnosis(1000), space);
    EXPECT_THAT(figures[0].panels.at(0).references, IsEmpty());
}

TEST(ScanFigures, ShowTheCosinesOfTheEffectsThatAreSeen) {
    const auto figures = scan_figures(diagnosis(100), space);
    const Panel& panel = figures[1].panels.at(0);
    EXPECT_THAT(panel.x_names, ElementsAre(ElementsAre("1"), ElementsAre("2")));
    const Curve& cells = panel.curves.at(0);
    EXPECT_THAT(cells.shade, ElementsAre(testing::DoubleEq(0.6), 1, 1));
    EXPECT_THAT(cells.names, ElementsAre("60", "100", "100"));
}

}  // namespace pendular::scan_figures_test
