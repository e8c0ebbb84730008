// Panels of a page: series that one curve can represent.
#include "reports/page/page_curves.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pendular::reports_page_curves_test {

using testing::ElementsAre;
using testing::HasSubstr;

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
    EXPECT_THAT(series[0].label, HasSubstr("20 g of beads"));
    EXPECT_THAT(series[1].label, HasSubstr("40 g of beads"));
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
    EXPECT_THAT(panels[0].series[0].label, HasSubstr(", a.csv"));
}

TEST(PagePanels, LeaveReplicatesOfOneFillingTogether) {
    std::vector<Reading> readings;
    for (const double stress : {300.0, 1000.0}) {
        readings.push_back(reading(stress, "a.csv", 0.0150, 2e-5));
        readings.push_back(reading(stress, "b.csv", 0.0151, 2.01e-5));
    }
    EXPECT_EQ(page_panels(readings, study())[0].series.size(), 1u);
}

}  // namespace pendular::reports_page_curves_test
