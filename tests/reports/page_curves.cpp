// Panels of a page: series that one curve can represent.
#include "reports/page/page_curves.h"

#include <cmath>
#include <numbers>

#include "data/annular_cell.h"
#include "tests/support/golden.h"

namespace pendular::reports_page_curves_test {

using testing::ElementsAre;

Reading reading(double normal_stress, const std::string& file, double height,
                std::optional<double> bead_volume = {}) {
    Reading one;
    one.origin.file = file;
    one.condition = {.normal_stress = normal_stress,
                     .inertial_number = 0.01,
                     .height = height,
                     .bead_volume = bead_volume};
    return one;
}

Study study() {
    Study study;
    study.grains = {.diameter = 5e-4, .density = 1000};
    return study;
}

TEST(PagePanels, HaveACurveForEachFilling) {
    std::vector<Reading> readings;
    for (const double stress : {300.0, 1000.0, 3000.0}) {
        readings.push_back(reading(stress, "a.csv", 0.015, 2e-5));
        readings.push_back(reading(stress * 1.01, "b.csv", 0.03, 4e-5));
    }
    const auto panels = page_panels(readings, study());
    ASSERT_EQ(panels.size(), 1u);
    const auto& series = panels[0].series;
    ASSERT_EQ(series.size(), 2u);
    EXPECT_THAT(series[0].members, ElementsAre(0, 2, 4));
    EXPECT_THAT(series[1].members, ElementsAre(1, 3, 5));
    expect_told({series[0].label, series[1].label});
    for (const Condition& condition : series[1].along) {
        EXPECT_NEAR(condition.height.value(), 0.03, 1e-12);
    }
    EXPECT_EQ(points_of_curves(panels).size(), series[0].along.size() + series[1].along.size());
}

TEST(PagePanels, TellFilesApartWhereTheMassIsUnknown) {
    std::vector<Reading> readings;
    for (const double stress : {300.0, 1000.0}) {
        readings.push_back(reading(stress, "folder/a.csv", 0.015));
        readings.push_back(reading(stress, "folder/b.csv", 0.03));
    }
    const auto panels = page_panels(readings, study());
    ASSERT_EQ(panels[0].series.size(), 2u);
    expect_told({panels[0].series[0].label});
}

TEST(PagePanels, LeaveReplicatesOfOneFillingTogether) {
    std::vector<Reading> readings;
    for (const double stress : {300.0, 1000.0}) {
        readings.push_back(reading(stress, "a.csv", 0.0150, 2e-5));
        readings.push_back(reading(stress, "b.csv", 0.0151, 2.01e-5));
    }
    EXPECT_EQ(page_panels(readings, study())[0].series.size(), 1u);
}

/// Readings at two speeds of the lid [rpm] and four normal stresses, each with an inertial number
/// of its own.
std::vector<Reading> at_constant_speed(const Study& study, double liquid_content) {
    std::vector<Reading> readings;
    for (const double rpm : {2.0, 20.0}) {
        for (const double stress : {200.0, 500.0, 1500.0, 5000.0}) {
            Reading one = reading(stress, "a.csv", 0.0065);
            const double rate = shear_rate(rpm * std::numbers::pi / 30, 0.0065, *study.cell);
            one.condition.inertial_number = inertial_number(rate, stress, study.grains);
            one.condition.liquid_content = liquid_content;
            readings.push_back(one);
        }
    }
    return readings;
}

TEST(PagePanels, HaveACurveForEachSpeedThatWasHeld) {
    Study of = study();
    of.cell = AnnularCell{.inner_radius = 0.015, .outer_radius = 0.03};
    of.liquid = Liquid{.surface_tension = 0.072};
    auto readings = at_constant_speed(of, 0);
    for (const double content : {0.01, 0.03}) {
        std::ranges::copy(at_constant_speed(of, content), std::back_inserter(readings));
    }
    const auto panels = page_panels(readings, of);
    ASSERT_EQ(panels.size(), 2u);
    ASSERT_EQ(panels[0].series.size(), 2u);  // dry: against the normal stress, at each speed
    expect_told({panels[0].series[1].label});
    ASSERT_EQ(panels[1].series.size(), 4u);
    EXPECT_EQ(panels[1].series[0].label, "liquid content 0.01, 2 rpm");
    for (const PagePanel& panel : panels) {
        for (const PageSeries& series : panel.series) {
            EXPECT_EQ(series.members.size(), 4u);
            EXPECT_FALSE(series.along.empty());
        }
    }
}

TEST(PagePanels, OfManyInertialNumbersHaveThemOnTheAxis) {
    Study of = study();
    of.liquid = Liquid{.surface_tension = 0.072};
    std::vector<Reading> readings;
    for (const double content : {0.0, 0.01, 0.03}) {
        for (const double stress : {500.0, 1000.0}) {
            for (int k = 0; k < 15; ++k) {
                Reading one = reading(stress, "a.csv", 0.015);
                one.condition.inertial_number = 0.003 * std::pow(26, k / 14.0);
                one.condition.liquid_content = content;
                readings.push_back(one);
            }
        }
    }
    const auto panels = page_panels(readings, of);
    ASSERT_EQ(panels.size(), 2u);
    for (const PagePanel& panel : panels) {
        EXPECT_EQ(panel.x_label, "inertial number I [1]");
        EXPECT_EQ(panel.quantity, "normal stress [Pa]");
    }
    EXPECT_EQ(panels[0].series.size(), 2u);
    ASSERT_EQ(panels[1].series.size(), 4u);
    EXPECT_EQ(panels[1].series[2].label, "liquid content 0.03, normal stress 500 Pa");
    EXPECT_EQ(panels[1].series[2].group, "liquid content 0.03");
    EXPECT_DOUBLE_EQ(panels[1].series[2].value, 500);
}

}  // namespace pendular::reports_page_curves_test
