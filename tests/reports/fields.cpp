#include <cmath>
#include <limits>

#include "reports/layout.h"
#include "reports/simulation_figures.h"
#include "tests/support/golden.h"

namespace reports_fields_test {

using namespace pendular;
using namespace pendular::dem;

/// A wet run whose fields are known: value k in bin k, error k/10; one bin with nothing in it.
RunResult planted_run() {
    RunResult run;
    run.parameters.wetting = Wetting{.reduced_pressure = 2, .bridge_volume = 4e-3};
    for (auto& field : run.fields) {
        for (int k = 1; k <= 4; ++k) {
            field.at.push_back(k / 8.0);
            field.means.push_back({1.0 * k, 0.1 * k});
        }
    }
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    run.fields[static_cast<std::size_t>(Field::contact_force_by_orientation)].means[2] = {nothing,
                                                                                          nothing};
    return run;
}

TEST(FieldTables, HoldTheFieldsOfOneCoordinateWithTheirErrors) {
    const auto tables = field_tables(planted_run());
    ASSERT_EQ(tables.size(), dem::coordinates.size());
    expect_told({tables.at("gaps.csv"), tables.at("orientations.csv")});
}

TEST(FieldFigures, ShowEveryFieldOfARun) {
    const auto figures = field_figures(planted_run());
    ASSERT_EQ(figures.size(), 2u);
    EXPECT_EQ(figures[0].panels.size(), 3u);
    ASSERT_EQ(figures[1].panels.size(), 4u);
    EXPECT_EQ(figures[1].panels[0].curves.size(), 2u);
    EXPECT_EQ(figures[1].panels[1].curves[0].x.size(), 3u);  // without the empty bin
    RunResult dry = planted_run();
    dry.parameters.wetting.reset();
    EXPECT_EQ(field_figures(dry)[1].panels.size(), 3u);
}

TEST(Page, PlacesDecadesEvenlyAndPanelsInRows) {
    const Panel panel{.log_y = true, .curves = {{.x = {0, 1, 2}, .y = {0.01, 0.1, 1}}}};
    const Page page = page_of({.panels = {panel, panel, panel}, .columns = 2});
    const auto y = [&](double value) { return page.panels[0].at(1, value).y; };
    EXPECT_NEAR(y(1) - y(0.1), y(0.1) - y(0.01), 1e-12);
    EXPECT_EQ(page.panels[0].bottom, page.panels[1].bottom);
    EXPECT_LT(page.panels[2].top, page.panels[0].bottom);
    EXPECT_EQ(page.panels[2].left, page.panels[0].left);
}

}  // namespace reports_fields_test
