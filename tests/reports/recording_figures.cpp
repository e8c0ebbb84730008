// Figures of a recording and of yield loci.
#include "reports/recording_figures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "data/annular_cell.h"
#include "reports/layout.h"
#include "reports/page/page_data.h"
#include "tests/support/data_support.h"
#include "workflow/study_input.h"

namespace pendular::reports_recording_figures_test {

const std::string cell_file = PENDULAR_SOURCE_DIR "/tests/data/formats/powder_cell_all.txt";

const Curve& curve_named(const Panel& panel, const std::string& label) {
    const auto found = std::ranges::find(panel.curves, label, &Curve::label);
    if (found == panel.curves.end()) throw std::runtime_error("no curve " + label);
    return *found;
}

std::size_t count_named(const Panel& panel, const std::string& label) {
    return static_cast<std::size_t>(std::ranges::count(panel.curves, label, &Curve::label));
}

/// Distance of the centre of a half circle of a figure from the fitted line, over its radius.
double distance_from(const Curve& circle, const Curve& line) {
    const double centre = (circle.x.front() + circle.x.back()) / 2;
    const double radius = (circle.x.back() - circle.x.front()) / 2;
    const double slope = (line.y[1] - line.y[0]) / (line.x[1] - line.x[0]);
    return (line.y[0] + slope * centre) / std::hypot(1, slope) / radius;
}

TEST(YieldLocusFigures, DrawTangentMohrCirclesOnEqualScales) {
    const FileView view = view_of_file(cell_file);
    const std::vector<Figure> figures = yield_locus_figures(view);
    ASSERT_EQ(figures.size(), 1u);
    const Panel& panel = figures[0].panels[0];
    EXPECT_EQ(curve_named(panel, "points of failure").x.size(), view.loci[0].points.size());
    EXPECT_EQ(curve_named(panel, "preshear").x.size(), 1u);
    const Curve& line = curve_named(panel, "yield locus");
    for (const char* const name : {"Mohr circle of preshear", "Mohr circle of strength"})
        EXPECT_NEAR(distance_from(curve_named(panel, name), line), 1, 1e-9) << name;
    // The circle of the unconfined strength begins where the smaller principal stress is 0.
    EXPECT_NEAR(curve_named(panel, "Mohr circle of strength").x.front(), 0, 1e-9);
    // The preshear is on its circle.
    const Curve& circle = curve_named(panel, "Mohr circle of preshear");
    const double centre = (circle.x.front() + circle.x.back()) / 2;
    const Curve& preshear = curve_named(panel, "preshear");
    EXPECT_NEAR(std::hypot(preshear.x[0] - centre, preshear.y[0]),
                (circle.x.back() - circle.x.front()) / 2, 1e-6 * centre);
    const PanelPlace place = page_of(figures[0]).panels[0];
    EXPECT_NEAR((place.x.second - place.x.first) / (place.right - place.left),
                (place.y.second - place.y.first) / (place.top - place.bottom),
                0.01 * (place.x.second - place.x.first) / (place.right - place.left));
}

/// Points (1000, 300), (2000, 900) Pa: the line meets the axis of normal stress at 500 Pa.
TEST(YieldLocusFigures, BeginALineThatFallsBelowZeroOnTheAxis) {
    FileView view;
    YieldLocus locus;
    locus.points = {{.normal_stress = 1000, .shear_stress = 300},
                    {.normal_stress = 2000, .shear_stress = 900}};
    locus.line = linear_yield_locus({1000, 2000}, {300, 900}, {});
    view.loci = {locus};
    const Figure figure = yield_locus_figures(view).at(0);
    const Curve& line = curve_named(figure.panels[0], "yield locus");
    EXPECT_NEAR(line.x[0], 500, 1e-9);
    EXPECT_NEAR(line.y[0], 0, 1e-9);
}

TEST(YieldLocusFigures, NameTheTestOfEachOfSeveral) {
    const TemporaryFolder folder;
    const auto figures = yield_locus_figures(view_of_file(folder.write(
        "t.csv",
        "Material;Normal stress [Pa];Shear stress [Pa]\nSand_1;1000;710\nSand_1;2000;1220\n"
        "Sand_1;3000;1730\nMehl;2000;1400\nMehl;4000;2420\nMehl;6000;3440\n")));
    ASSERT_EQ(figures.size(), 2u);
    EXPECT_THAT(unescaped(figures[0].title), testing::StartsWith("Sand_1: cohesion 200"));
    EXPECT_THAT(figures[1].title, testing::StartsWith("Mehl: cohesion 380"));
}

TEST(RecordingFigure, IsNotDrawnOfAReport) {
    const FileView view =
        view_of_file(PENDULAR_SOURCE_DIR "/tests/data/formats/yield_locus_report.txt");
    for (const Figure& figure : file_figures(view))
        EXPECT_TRUE(figure.name.starts_with("yield_locus")) << figure.name;
}

TEST(RecordingFigure, ShowsWhatIsAveraged) {
    const FileView view = view_of_file(cell_file);
    const Figure figure = recording_figure(view);
    ASSERT_EQ(figure.panels.size(), 2u);
    const auto preshears = std::ranges::count_if(
        view.roles, [](const IntervalRole& role) { return role.role == "preshear"; });
    const std::size_t windows = count_named(figure.panels[0], "averaged") +
                                count_named(figure.panels[0], "averaged, no plateau");
    EXPECT_EQ(windows, view.loci[0].points.size() + static_cast<std::size_t>(preshears));
}

TEST(RecordingFigure, TellsAPlateauFromNone) {
    const TemporaryFolder folder;
    const auto file = [&](double rise) {
        std::string text = "Point No.,Normal Stress,Shear Stress\n,[Pa],[Pa]\n";
        for (const double normal : {3000.0, 1000.0})
            for (int i = 1; i <= 100; ++i)
                text += std::to_string(i) + "," + std::to_string(normal) + "," +
                        std::to_string(0.3 * normal * (i < 50 ? 0.02 * i : 1 + rise * (i - 50))) +
                        "\n";
        return folder.write("test.csv", text);
    };
    const FileView steady = view_of_file(file(0)), rising = view_of_file(file(0.004));
    ASSERT_EQ(steady.roles[0].role, "preshear");
    EXPECT_TRUE(preshear_point(steady.series[0]).plateau);
    EXPECT_FALSE(preshear_point(rising.series[0]).plateau);
    EXPECT_EQ(count_named(recording_figure(steady).panels[0], "averaged, no plateau"), 0u);
    // The preshear and the failure, whose peak is at its last row.
    EXPECT_EQ(count_named(recording_figure(rising).panels[0], "averaged, no plateau"), 2u);
}

TEST(RecordingFigure, ShowsTheRowsOfReadings) {
    const FileView view = view_of_file(cell_file);
    Reading reading;
    reading.origin = {view.file.file, view.series[0].line[4], 0};
    reading.last_line = view.series[0].line[13];
    const Figure figure = recording_figure(view, {reading});
    const Curve& window = curve_named(figure.panels[0], "averaged");
    EXPECT_THAT(window.x, testing::ElementsAre(5, 14));
    double mean = 0;
    for (std::size_t i = 4; i < 14; ++i)
        mean += std::abs(view.series[0].shear_stress[i]) / 10;
    EXPECT_NEAR(window.y[0], mean, 1e-9);
}

TEST(RecordingFigure, ShowsStepsThatNeverBecameSteadyButNoRunIn) {
    const FileView view = view_of_file(cell_file);
    const auto rows = [&](std::size_t from, std::size_t to, Remark::Kind kind) {
        return Remark{.kind = kind,
                      .files = {view.file.file},
                      .lines = {{view.series[0].line[from], view.series[0].line[to]}}};
    };
    const Figure figure = recording_figure(
        view, {}, {rows(0, 3, Remark::Kind::spike), rows(4, 13, Remark::Kind::never_steady)});
    EXPECT_EQ(count_named(figure.panels[0], "averaged"), 0u);
    EXPECT_THAT(curve_named(figure.panels[0], "averaged, no plateau").x,
                testing::ElementsAre(5, 14));
}

TEST(RecordingFigure, OfAStudyShowsEachReadingAndNoTransient) {
    const StudyInput input = read_input(PENDULAR_SOURCE_DIR "/examples/hidden-effect");
    const auto path = std::filesystem::path(input.measurements.readings[0].origin.file);
    const Figure figure = recording_figure(view_of_file(path), input.measurements.readings,
                                           input.measurements.left_out());
    ASSERT_EQ(figure.panels.size(), 2u);
    for (const Panel& panel : figure.panels) {
        EXPECT_EQ(count_named(panel, "averaged"), 6u);  // three normal stresses, two speeds
        EXPECT_EQ(panel.curves.size(), 7u);             // and what was recorded
    }
}

/// Recording of 10,000 rows at 300 Pa with one row at 900 Pa.
FileView long_recording(const TemporaryFolder& folder) {
    std::string text = "Point No.,Normal Stress,Shear Stress\n,[Pa],[Pa]\n";
    for (int i = 1; i <= 10'000; ++i)
        text += std::to_string(i) + ",1000," + (i == 4567 ? "900" : "300") + "\n";
    return view_of_file(folder.write("long.csv", text));
}

TEST(RecordingCourse, KeepsAPeakOfOneRowWhenItIsThinned) {
    const TemporaryFolder folder;
    const auto points = RecordingCourse(long_recording(folder), true).points(400);
    EXPECT_LE(points.size(), 400u);
    EXPECT_GE(points.size(), 200u);
    EXPECT_THAT(points, testing::Contains(testing::Pair(4567, 900.)));
    EXPECT_TRUE(std::ranges::is_sorted(points));
}

TEST(PageRecordings, HoldEachReadingOfAStudy) {
    const StudyInput input = read_input(PENDULAR_SOURCE_DIR "/examples/hidden-effect");
    const Measurements& measurements = input.measurements;
    const auto path = std::filesystem::path(measurements.readings[7].origin.file);
    const PageRecording recording =
        page_recording(view_of_file(path), measurements.readings, measurements.left_out(), 400);
    const auto json = recordings_json({recording}, measurements.readings);
    ASSERT_EQ(json.size(), 1u);
    EXPECT_EQ(json[0]["name"], path.filename().string());
    ASSERT_EQ(json[0]["parts"].size(), 2u);
    // 400 points of two bytes for the time and two for the value, as base64.
    EXPECT_LE(json[0]["parts"][0]["points"].get<std::string>().size(), 400u * 4 * 4 / 3 + 4);
    ASSERT_EQ(json[0]["windows"].size(), 6u);
    for (const auto& window : json[0]["windows"]) {
        const Reading& reading = measurements.readings.at(window["reading"].get<std::size_t>());
        EXPECT_EQ(reading.origin.file, path.string());
        // The mean torque makes the shear stress of the reading.
        EXPECT_NEAR(shear_stress(window["means"][0].get<double>(), *input.study.study().cell),
                    reading.value(0), 1e-4 * reading.value(0));
    }
}

TEST(PageRecordings, OfManyHaveFewerPoints) {
    EXPECT_EQ(points_of_recordings(10), 400u);
    EXPECT_LE(2 * 300 * points_of_recordings(300), 12'000u);
}

}  // namespace pendular::reports_recording_figures_test
