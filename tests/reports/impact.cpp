// Sentences, table, figure and JSON of impacts on a friction of 0.3 with a standard error of 0.01.
#include "reports/impact_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "reports/impact_figure.h"
#include "workflow/impact_json.h"

namespace pendular::impact_report_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

Eigen::VectorXd one(double value) {
    return Eigen::VectorXd::Constant(1, value);
}

/// Effect that lowers the friction by a tenth of its size. Estimate: `size` with this error.
Impact impact(const std::string& name, double interest, double size, double error) {
    const auto shift = [](double at) { return Shift{at, one(-0.1 * at), one(-0.1 * at), {}}; };
    return {.name = name,
            .quantity = "coefficient",
            .unit = "1",
            .group = "instrument",
            .error = error,
            .at_interest = shift(interest),
            .at_estimate = shift(size),
            .above = shift(size + error),
            .below = shift(size - error)};
}

ImpactTable table() {
    return {.parameters = {{.name = "friction"}},
            .fitted = one(0.3),
            .errors = one(0.01),
            .impacts = {impact("wall-friction", 0.4, 0.8, 0.2), impact("lid-slip", 0.2, 0, 0.5),
                        impact("drag", 0.15, 0, 0.1), impact("wobble", 0.001, 0, 0.1)},
            .groups = {{"instrument", one(0.05), one(0.08), one(0.06)}}};
}

TEST(ImpactReport, SortsEffectsByHowMuchTheyShiftTheFriction) {
    EXPECT_THAT(by_impact(table(), {"bead-loss", "lid-slip", "wall-friction"}),
                ElementsAre("wall-friction", "lid-slip", "bead-loss"));
}

TEST(ImpactReport, TableHasEachImpactAndEachGroup) {
    const std::vector<std::string> rows = impact_table(table());
    ASSERT_EQ(rows.size(), 1u + 4 + 1 + 1);
    EXPECT_THAT(rows[1], HasSubstr("wall-friction"));
    EXPECT_THAT(rows[1], HasSubstr("4.0"));  // pull
    EXPECT_THAT(rows[5], HasSubstr("sum, instrument"));
}

TEST(ImpactFigure, RanksTheShiftsByTheErrorsOfTheSizes) {
    const Figure figure = impact_figure(table());
    ASSERT_EQ(figure.panels.size(), 2u);
    EXPECT_EQ(figure.panels[0].y_names.back(), "lid-slip");  // the top row
    const Curve& up = figure.panels[0].curves[0];
    EXPECT_NEAR(up.x.back(), -50, 1e-9);  // in thousandths
    EXPECT_NEAR(figure.panels[0].curves[1].x.back(), 50, 1e-9);
    EXPECT_NEAR(figure.panels[1].curves[0].x[2], 4, 1e-12);  // pull of wall-friction
}

TEST(ImpactJson, HasAllShifts) {
    const auto json = to_json(table());
    EXPECT_EQ(json["single"][0]["at_estimate"]["shift"]["friction"], -0.1 * 0.8);
    EXPECT_TRUE(json["single"][0]["at_estimate"]["refitted_shift"].is_null());
    EXPECT_EQ(json["groups"][0]["by_stderr"]["friction"], 0.06);
}

}  // namespace pendular::impact_report_test
