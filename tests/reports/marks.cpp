// Marks and keys of figures.
#include "reports/layout.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pendular::reports_marks_test {

/// Commands that draw the marks of a figure with one panel, a reference line and a key.
std::string drawn(double headroom, Key key) {
    Panel panel{.x_label = "x", .y_label = "y"};
    panel.references = {{"expected", 0, 1, true, "#888888"}};
    panel.curves = {{.label = "measured", .x = {0, 1}, .y = {0, 1}}};
    panel.key = key;
    panel.headroom = headroom;
    const Figure figure{.name = "figure", .title = "", .panels = {panel}};
    const Page page = page_of(figure);
    return marks_of(figure, page).script(page.width, page.height);
}

TEST(Key, IsNotCrossedByReferenceLines) {
    const auto covers = testing::HasSubstr("fillcolor rgb '#ffffff'");
    EXPECT_THAT(drawn(0.3, Key::top_left), covers);
    EXPECT_THAT(drawn(0.3, Key::top_right), covers);
    // Where no room is kept free, nothing of the data is covered.
    EXPECT_THAT(drawn(0, Key::top_left), testing::Not(covers));
    EXPECT_THAT(drawn(0.3, Key::bottom_left), testing::Not(covers));
}

}  // namespace pendular::reports_marks_test
