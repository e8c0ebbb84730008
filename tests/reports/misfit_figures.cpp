// Figures on the parts of chi2 and on the distribution of the residuals.
#include "reports/misfit_figures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace pendular::misfit_figures_test {

using testing::ElementsAre;
using testing::IsEmpty;

Comparison comparison_of(std::size_t count) {
    Comparison all;
    for (std::size_t k = 0; k < count; ++k) {
        ReadingMisfit misfit;
        const double shear = 0.5 * static_cast<double>(k) - 1;
        misfit.chi2 = {shear * shear, 0.25};
        misfit.normalised = {shear, -0.5};
        all.readings.push_back(misfit);
        all.by_observable[0] += shear * shear;
        all.by_observable[1] += 0.25;
    }
    all.total.chi2 = all.by_observable[0] + all.by_observable[1];
    return all;
}

const Figure& named(const std::vector<Figure>& figures, const std::string& name) {
    return *std::ranges::find(figures, name, &Figure::name);
}

TEST(MisfitFigures, OrderTheResidualsAlongTheNormalQuantiles) {
    const auto figures = misfit_figures(comparison_of(5));
    const Panel& panel = named(figures, "qq").panels.at(0);
    const Curve& shear = panel.curves.at(2);
    EXPECT_EQ(shear.label, "shear stress");
    EXPECT_THAT(shear.y, ElementsAre(-1, -0.5, 0, 0.5, 1));
    EXPECT_NEAR(shear.x[2], 0, 1e-12);
    EXPECT_NEAR(shear.x[0], -shear.x[4], 1e-12);
    EXPECT_NEAR(shear.x[4], 1.18, 0.005);  // Blom's median of the largest of five
}

// The largest part of each group is drawn at its top, as the last of its y values.
TEST(MisfitFigures, LedgerHasEachPartPerMeasuredValue) {
    Comparison all = comparison_of(4);
    all.by_file = {{"x/a.csv", 3, 2.0}, {"x/b.csv", 1, 0.5}};
    const auto figures = misfit_figures(all);
    const Panel& panel = named(figures, "chi2_ledger").panels.at(0);
    EXPECT_THAT(panel.y_names, ElementsAre("b.csv", "a.csv", "", "solid fraction", "shear stress"));
    EXPECT_THAT(panel.curves.at(0).y, ElementsAre(1, 2, 4, 5));
    EXPECT_NEAR(panel.curves.at(0).x[0], 0.5 / 2, 1e-12);
    EXPECT_NEAR(panel.curves.at(0).x[1], 2.0 / 6, 1e-12);
    EXPECT_NEAR(panel.curves.at(0).x[3], all.by_observable[0] / 4, 1e-12);
}

TEST(MisfitFigures, DrawNothingWithoutReadings) {
    EXPECT_THAT(misfit_figures({}), IsEmpty());
}

}  // namespace pendular::misfit_figures_test
