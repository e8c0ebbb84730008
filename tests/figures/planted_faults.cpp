// The check of figures finds each fault that is planted into a figure without one.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/figure_faults.h"

namespace pendular::planted_faults_test {

using figure_check::faults_of;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

/// Two series of measured points with their models, as figures of a study draw them.
Figure sound() {
    Panel panel{.x_label = "normal stress [Pa]", .y_label = "stress ratio μ*", .key = true};
    const std::vector<std::string> names = {"dry", "wet"};
    for (std::size_t s = 0; s < names.size(); ++s) {
        const SeriesLook look = look_of_series(s, names.size());
        Curve measured = measured_points("measured, " + names[s], look),
              line = model_line("model, " + names[s], look);
        const double level = 0.3 + 0.1 * static_cast<double>(s);
        measured.x = line.x = {300, 1000, 3000};
        measured.y = line.y = {level, level + 0.01, level + 0.02};
        measured.y_error = {0.01, 0.01, 0.01};
        measured.in_key = line.in_key = false;
        Curve band = line;
        band.style = Curve::Style::band;
        band.y_error = {0.005, 0.005, 0.005};
        panel.curves.insert(panel.curves.end(), {band, line, measured});
    }
    std::ranges::move(series_entries(names), std::back_inserter(panel.curves));
    panel.curves.push_back(kind_entry(measured_text, Curve::Style::points));
    panel.curves.push_back(kind_entry(model_text, Curve::Style::line));
    return {.name = "figure", .title = "A figure without faults", .panels = {panel}};
}

Panel& panel_of(Figure& figure) {
    return figure.panels.front();
}

void expect_fault(const Figure& figure, const std::string& fault) {
    EXPECT_THAT(faults_of(figure), Contains(HasSubstr(fault)));
}

TEST(FigureCheck, FindsNothingInASoundFigure) {
    EXPECT_THAT(faults_of(sound()), IsEmpty());
}

TEST(FigureCheck, FindsDataOutsideTheAxes) {
    Figure figure = sound();
    panel_of(figure).y_range = {{0.3, 0.5}};  // cuts the error bar of the first point
    expect_fault(figure, "'measured, dry' lies outside the axes");
    figure = sound();
    panel_of(figure).references = {{"limit", 5000, 0, true, "#888888"}};
    panel_of(figure).x_range = {{100, 4000}};
    expect_fault(figure, "'limit' lies outside the axes");
}

TEST(FigureCheck, FindsALineThatIsNotSeen) {
    Figure figure = sound();
    Curve& line = panel_of(figure).curves[1];
    line.x.resize(1), line.y.resize(1);
    expect_fault(figure, "'model, dry' has a single point");
}

TEST(FigureCheck, FindsTextsThatOverlapOrLeaveThePage) {
    Figure figure = sound();
    panel_of(figure).curves[2].names = {"0.3000000", "0.3000000", "0.3000000"};
    panel_of(figure).curves[2].x = {1000, 1100, 1200};
    panel_of(figure).curves[2].y = {0.35, 0.35, 0.35};
    expect_fault(figure, "'0.3000000' and '0.3000000' overlap");
    figure = sound();
    panel_of(figure).curves[2].names = {"", "text", ""};
    panel_of(figure).curves[5].y[1] = 0.33;  // a point where the text stands
    expect_fault(figure, "'text' and 'measured, wet' overlap");
    figure = sound();
    figure.title = std::string(100, 'm');  // without a blank at which it could be broken
    expect_fault(figure, "mmm' leaves the page");
    figure = sound();
    panel_of(figure).y_label =
        "stress ratio, explained at a length that no axis of any page has "
        "room for";
    expect_fault(figure, "room for' leaves the page");
}

TEST(FigureCheck, FindsSeriesWithoutAnEntry) {
    Figure figure = sound();
    panel_of(figure).curves[2].colour = "#777777";
    expect_fault(figure, "'measured, dry' is not in the key");
    figure = sound();
    panel_of(figure).curves.pop_back();  // the entry of the model
    expect_fault(figure, "'model, wet' is not in the key");
    figure = sound();
    panel_of(figure).key = false;
    expect_fault(figure, "'measured, dry' is not in the key");
}

TEST(FigureCheck, FindsEntriesWithoutASeries) {
    Figure figure = sound();
    panel_of(figure).curves.push_back(
        kind_entry("model at the readings", Curve::Style::points, Filling::hollow));
    expect_fault(figure, "nothing is drawn for 'model at the readings'");
}

TEST(FigureCheck, FindsErrorBarsOnTheWrongAxis) {
    Figure figure = sound();
    panel_of(figure).x_uncertain = true;  // measured along x too
    expect_fault(figure, "'measured, dry' has its error bars on the wrong axis");
    figure = sound();
    Curve& measured = panel_of(figure).curves[2];
    measured.x_error = {1, 1, 1};
    expect_fault(figure, "'measured, dry' has its error bars on the wrong axis");
    figure = sound();
    panel_of(figure).curves[2].in_key = true;
    panel_of(figure).curves[2].label += ", ± 1 standard error";
    panel_of(figure).curves[2].y_error.clear();
    expect_fault(figure, "has no error bars");
}

TEST(FigureCheck, FindsAnAxisWithoutAUnit) {
    Figure figure = sound();
    panel_of(figure).x_label = "normal stress";
    expect_fault(figure, "axis 'normal stress' has no unit");
}

TEST(FigureCheck, FindsALongKey) {
    Figure figure = sound();
    for (int k = 0; k < 5; ++k) {
        Curve more{.label = fmt::format("series {}", k), .x = {1000}, .y = {0.35}};
        more.symbol = {Shape::star, Filling::hollow};
        panel_of(figure).curves.push_back(more);
    }
    expect_fault(figure, "a key has 9 entries");
}

TEST(FigureCheck, FindsTextsThatAreTooSmallInPrint) {
    Figure figure = sound();
    figure.panels.assign(8, figure.panels.front());  // side by side
    expect_fault(figure, " pt at 178 mm");
}

TEST(FigureCheck, FindsEntriesThatDifferInColourAlone) {
    Figure figure = sound();
    for (const char* const colour : {"#c0392b", "#0b62a4"}) {  // red and blue, equally dark
        panel_of(figure).curves.push_back({.label = colour, .x = {1000}, .y = {0.35}});
        panel_of(figure).curves.back().colour = colour;
    }
    expect_fault(figure, "'#c0392b' and '#0b62a4' are one in grey");
}

}  // namespace pendular::planted_faults_test
