// Sentences, table, figure and JSON of impacts on a friction of 0.3 with a standard error of 0.01.
#include "reports/impact_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "calib/fit/calibration_notes.h"
#include "reports/draw_figure.h"
#include "reports/with_error.h"
#include "tests/support/golden.h"
#include "tests/support/made_up_impact.h"
#include "workflow/json/diagnosis.h"

namespace pendular::impact_report_test {

using made_up::impact;
using made_up::one;
using ::testing::ElementsAre;

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
    expect_told(impact_table(table()));
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

// At a bound of the friction no effect shifts it: that panel would have an empty axis.
TEST(ImpactFigure, HasNoPanelWithoutAnExtent) {
    ImpactTable still = table();
    still.errors = one(0);
    for (Impact& each : still.impacts) {
        for (Shift* shift : {&each.at_interest, &each.at_estimate, &each.above, &each.below})
            shift->linear = shift->bounded = one(0);
    }
    EXPECT_LE(impact_figure(still).panels.size(), 1u);
    const TemporaryFolder folder;
    Figure figure = impact_figure(table());
    figure.panels.front().x_range = {0, 0};
    EXPECT_TRUE(draw(figure, folder.path()));
    figure.panels.erase(figure.panels.begin() + 1, figure.panels.end());
    figure.name = "empty";
    EXPECT_FALSE(draw(figure, folder.path()));
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "empty.svg"));
}

TEST(Figures, LeaveOutValuesThatAreNotFinite) {
    const TemporaryFolder folder;
    const double none = std::numeric_limits<double>::quiet_NaN(), over = INFINITY;
    Panel panel{.x_label = "x", .y_label = "y"};
    panel.curves = {{.x = {1, none, 2}, .y = {1, 2, over}, .y_error = {0.1, none, 0.1}},
                    {.style = Curve::Style::line, .x = {1, 2, 3, 4}, .y = {1, none, over, 2}},
                    {.style = Curve::Style::bars_across, .x = {1, 2}, .y = {none, none}}};
    panel.references = {{.label = "r", .value = none}};
    EXPECT_TRUE(draw({.name = "gaps", .title = "", .panels = {panel}}, folder.path()));
    std::ifstream file(folder.path() / "gaps.svg");
    const std::string svg{std::istreambuf_iterator<char>(file), {}};
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(svg.find("inf"), std::string::npos);
}

TEST(EstimateText, SaysWhereTheErrorSaysNothing) {
    // A friction between 0 and 0.6.
    EXPECT_EQ(estimate_text(0.15634, 353312, "1", 0.6, false), "0.1563, not determined");
    EXPECT_EQ(estimate_text(0.15634, 0.012, "1", 0.6, false), "0.156 +- 0.012");
    EXPECT_EQ(estimate_text(0.6, 0.091, "1", 0.6, true), "0.600 +- 0.091 (at bound)");
}

TEST(RangeText, NamesTheEndOfTheSimulations) {
    const std::vector<Parameter> friction = {{.name = "friction", .lower = 0, .upper = 1}};
    Fit fit{.parameters = one(0.6), .range = {one(0), one(0.6)}};
    EXPECT_EQ(range_text(fit, friction, 0), "0 to 0.6 (0.6 is the end of the simulations)");
    fit.range.upper = one(1);
    fit.parameters = one(1);
    EXPECT_EQ(range_text(fit, friction, 0), "0 to 1");
    EXPECT_FALSE(implausible_friction(0.09));
    expect_told({*implausible_friction(0.043), *implausible_friction(0.9)});
}

TEST(ExtrapolationNote, CountsReadingsSlowerThanAllRuns) {
    std::vector<dem::RunResult> runs(2);
    runs[0].parameters.inertial_number = 1e-3, runs[1].parameters.inertial_number = 0.1;
    std::vector<Reading> readings(3);
    readings[0].condition.inertial_number = 1e-4;
    readings[1].condition.inertial_number = 1e-3;
    readings[2].condition.inertial_number = 2e-4;
    expect_told({*extrapolation_note(runs, readings)});
    EXPECT_FALSE(extrapolation_note(runs, {readings[1]}));
}

TEST(ImpactJson, HasAllShifts) {
    const auto json = to_json(table());
    EXPECT_EQ(json["single"][0]["at_estimate"]["shift"]["friction"], -0.1 * 0.8);
    EXPECT_TRUE(json["single"][0]["at_estimate"]["refitted_shift"].is_null());
    EXPECT_EQ(json["groups"][0]["by_stderr"]["friction"], 0.06);
}

}  // namespace pendular::impact_report_test
