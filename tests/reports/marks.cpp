// Marks and keys of figures.
#include "reports/layout.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/key.h"
#include "reports/text_width.h"

namespace pendular::reports_marks_test {

Panel panel_with_key() {
    Panel panel{.x_label = "x", .y_label = "y"};
    panel.references = {{"expected", 0, 1, true, "#888888"}};
    panel.curves = {{.label = "measured", .x = {0, 1}, .y = {0, 1}}};
    panel.key = true;
    return panel;
}

TEST(Key, StandsBelowTheTitleAndAboveTheAxes) {
    const Page page = page_of({.name = "", .title = "title", .panels = {panel_with_key()}});
    ASSERT_EQ(page.keys.size(), 1u);
    const KeyPlace& key = page.keys.front();
    EXPECT_LT(key.corner.y, page.height - 0.2);
    EXPECT_GE(key.corner.y - key.layout.height(), page.panels[0].top);
}

TEST(Key, OfEachPanelStandsAboveIt) {
    const Figure figure{
        .name = "", .title = "", .panels = {panel_with_key(), panel_with_key()}, .stacked = true};
    const Page page = page_of(figure);
    ASSERT_EQ(page.keys.size(), 2u);
    EXPECT_LT(page.keys[1].corner.y, page.panels[0].bottom);
    EXPECT_GE(page.keys[1].corner.y - page.keys[1].layout.height(), page.panels[1].top);
}

TEST(Key, HasAsManyColumnsAsItsWidthHolds) {
    Panel panel = panel_with_key();
    EXPECT_EQ(key_layout(panel, 5).rows, 1u);
    EXPECT_EQ(key_layout(panel, 1).rows, 2u);
    panel.curves.push_back(panel.curves.front());  // the same entry once more
    EXPECT_EQ(key_entries(panel).size(), 2u);
}

TEST(Page, IsPrintedInAColumnOrOverTheWholeWidth) {
    Figure figure{.name = "", .title = "", .panels = {panel_with_key()}};
    EXPECT_NEAR(page_of(figure).width, column_page, 1e-12);
    EXPECT_EQ(page_of(figure).printed_width(), column_in_print);
    figure.panels.push_back(panel_with_key());
    EXPECT_NEAR(page_of(figure).width, wide_page, 1e-12);
    EXPECT_EQ(page_of(figure).printed_width(), whole_in_print);
}

TEST(TextWidth, IsThatOfDejaVuSans) {
    // Advance widths of "m" and "i": 0.974 and 0.278 of the size of 12/96 inch.
    EXPECT_NEAR(text_width("mi"), (0.974 + 0.278) / 8, 1e-12);
    EXPECT_NEAR(text_width("m^{ii}"), (0.974 + 0.8 * 2 * 0.278) / 8, 1e-12);
    EXPECT_NEAR(text_width(plain_text("m_{i}")), text_width("mi") + (0.5 + 2 * 0.636) / 8, 1e-12);
    EXPECT_EQ(text_width("γ̇"), text_width("γ"));  // an accent has no width
}

}  // namespace pendular::reports_marks_test
