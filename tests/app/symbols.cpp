// Symbols: Badetti et al.'s code, their geometry, and what really arrives on paper.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <sstream>

#include "reports/draw_figure.h"
#include "reports/layout.h"
#include "reports/symbol.h"
#include "tests/support/app_support.h"

namespace reports_symbols_test {

using namespace pendular;
using testing::IsEmpty;
using testing::SizeIs;

constexpr Shape with_inside[] = {Shape::square, Shape::triangle,          Shape::circle,
                                 Shape::star,   Shape::downward_triangle, Shape::diamond};
constexpr Filling fillings[] = {Filling::filled, Filling::bottom_half, Filling::hollow,
                                Filling::crossed, Filling::top_half};

/// Area and centre of a closed outline, by the shoelace formula.
struct Moments {
    double area = 0, x = 0, y = 0;
};
Moments moments(const Outline& outline) {
    Moments m;
    for (std::size_t k = 0; k + 1 < outline.size(); ++k) {
        const auto &a = outline[k], &b = outline[k + 1];
        const double wedge = a.x * b.y - b.x * a.y;
        m.area += wedge / 2;
        m.x += (a.x + b.x) * wedge / 6, m.y += (a.y + b.y) * wedge / 6;
    }
    m.x /= m.area, m.y /= m.area, m.area = std::abs(m.area);
    return m;
}
double area(const std::vector<Outline>& outlines) {
    double sum = 0;
    for (const auto& outline : outlines) {
        sum += moments(outline).area;
    }
    return sum;
}
std::pair<double, double> extent_in_y(const std::vector<Outline>& outlines) {
    double least = 1e9, greatest = -1e9;
    for (const auto& outline : outlines) {
        for (const auto& p : outline) {
            least = std::min(least, p.y), greatest = std::max(greatest, p.y);
        }
    }
    return {least, greatest};
}

int channel(std::string_view colour, int which) {
    return std::stoi(std::string(colour.substr(1 + 2 * static_cast<std::size_t>(which), 2)),
                     nullptr, 16);
}

TEST(SymbolCode, IsTheSourcesTable) {
    const std::pair<double, Shape> shapes[] = {{0.05, Shape::square},
                                               {0.09, Shape::triangle},
                                               {0.15, Shape::circle},
                                               {0.20, Shape::star},
                                               {0.25, Shape::downward_triangle}};
    for (const auto& [friction, shape] : shapes) {
        EXPECT_EQ(shape_of(friction), shape) << friction;
    }
    const std::pair<double, Filling> contents[] = {{0.003, Filling::filled},
                                                   {0.007, Filling::bottom_half},
                                                   {0.014, Filling::hollow},
                                                   {0.030, Filling::crossed},
                                                   {0.063, Filling::top_half}};
    for (const auto& [content, filling] : contents) {
        EXPECT_EQ(code_of(content).filling, filling) << content;
    }
    const auto rgb = [](double content) {
        const auto colour = code_of(content).colour;
        return std::array{channel(colour, 0), channel(colour, 1), channel(colour, 2)};
    };
    const auto red = rgb(0.003), blue = rgb(0.007), green = rgb(0.014), black = rgb(0.03),
               purple = rgb(0.063), grey = rgb(0);
    EXPECT_GT(red[0], 3 * std::max(red[1], red[2]));
    EXPECT_GT(blue[2], 2 * std::max(blue[0], blue[1]));
    EXPECT_GT(green[1], 2 * std::max(green[0], green[2]));
    EXPECT_LT(std::ranges::max(black), 40);
    EXPECT_GT(std::min(purple[0], purple[2]), 2 * purple[1]);
    EXPECT_TRUE(grey[0] == grey[1] && grey[1] == grey[2] && grey[0] > 80);
}

TEST(SymbolCode, TakesTheNearestOfTheTable) {
    EXPECT_EQ(shape_of(0.0), Shape::square);
    EXPECT_EQ(shape_of(0.08), Shape::triangle);
    EXPECT_EQ(shape_of(0.8), Shape::downward_triangle);
    // Of 0.003 and 0.007 the former is nearer to 0.0047, but not in the logarithm.
    EXPECT_EQ(code_of(0.0047).liquid_content, 0.007);
    EXPECT_EQ(code_of(1e-5).liquid_content, 0.003);
    EXPECT_EQ(code_of(0.2).liquid_content, 0.063);
    EXPECT_EQ(simulated_symbol(0.1, 0.0075), (Symbol{Shape::triangle, Filling::bottom_half}));
}

TEST(Symbol, HasTheAreaOneAboutItsPlaceWhateverItsShape) {
    for (const Shape shape : with_inside) {
        const Moments edge = moments(drawing_of({shape, Filling::hollow}).strokes.front());
        EXPECT_NEAR(edge.area, 1, 1e-12);
        EXPECT_NEAR(edge.x, 0, 1e-12);
        EXPECT_NEAR(edge.y, 0, 1e-12);
    }
}

TEST(Symbol, IsFilledAsItsFillingSays) {
    for (const Shape shape : with_inside) {
        const auto fills = [&](Filling filling) { return drawing_of({shape, filling}).fills; };
        EXPECT_THAT(fills(Filling::hollow), IsEmpty());
        EXPECT_THAT(fills(Filling::crossed), IsEmpty());
        EXPECT_NEAR(area(fills(Filling::filled)), 1, 1e-12);
        const auto [least, greatest] = extent_in_y(fills(Filling::filled));
        const auto lower = extent_in_y(fills(Filling::bottom_half)),
                   upper = extent_in_y(fills(Filling::top_half));
        const double middle = (least + greatest) / 2;
        EXPECT_NEAR(lower.first, least, 1e-12);
        EXPECT_NEAR(lower.second, middle, 1e-12);
        EXPECT_NEAR(upper.first, middle, 1e-12);
        EXPECT_NEAR(upper.second, greatest, 1e-12);
        EXPECT_NEAR(area(fills(Filling::bottom_half)) + area(fills(Filling::top_half)), 1, 1e-12);
    }
}

TEST(Symbol, IsCrossedFromEdgeToEdge) {
    // The diagonals of a square of side 1 end in its corners.
    const auto strokes = drawing_of({Shape::square, Filling::crossed}).strokes;
    ASSERT_THAT(strokes, SizeIs(3));
    for (std::size_t k : {1, 2}) {
        ASSERT_THAT(strokes[k], SizeIs(2));
        for (const auto& end : strokes[k]) {
            EXPECT_NEAR(std::abs(end.x), 0.5, 1e-12);
            EXPECT_NEAR(std::abs(end.y), 0.5, 1e-12);
        }
    }
}

TEST(Symbol, OfAMeasurementReachesOutOfAllOthers) {
    const auto plus = drawing_of(measured_symbol);
    EXPECT_THAT(plus.fills, IsEmpty());
    const auto [bottom, top] = extent_in_y(plus.strokes);
    EXPECT_GT(top, extent_in_y(drawing_of({Shape::triangle, Filling::filled}).fills).second);
    EXPECT_LT(bottom,
              extent_in_y(drawing_of({Shape::downward_triangle, Filling::filled}).fills).first);
}

/// Every symbol once, each in a colour of its own, at (number of its shape, number of its filling),
/// on axes of different scales.
Figure every_symbol() {
    Panel panel{.x_label = "shape", .y_label = "filling", .key = true};
    for (int shape = 0; shape < 6; ++shape) {
        for (int filling = 0; filling < 5; ++filling) {
            panel.curves.push_back(
                {.label = "symbol",
                 .x = {1.0 + shape},
                 .y = {100.0 * filling},
                 .y_error = {20},
                 .colour = fmt::format("#{:02x}{:02x}c8", 10 + 40 * shape, 10 + 50 * filling),
                 .symbol = {with_inside[shape], fillings[filling]},
                 .in_key = shape == 0});
        }
    }
    return {.name = "symbols", .title = "", .panels = {panel}};
}

/// Filled polygons of a colour in an SVG drawing, in inches from the lower left corner.
std::vector<Outline> polygons_of(const std::string& svg, const std::string& colour, double height) {
    const std::regex polygon(
        fmt::format(R"re(<polygon fill = 'rgb\(\s*{},\s*{},\s*{}\)'[^>]*points = '([^']*)')re",
                    channel(colour, 0), channel(colour, 1), channel(colour, 2)));
    std::vector<Outline> result;
    for (std::sregex_iterator it(svg.begin(), svg.end(), polygon), end; it != end; ++it) {
        std::istringstream points((*it)[1]);
        Outline& outline = result.emplace_back();
        char comma = 0;
        for (PaperPoint p; points >> p.x >> comma >> p.y;) {
            outline.push_back({p.x / 96, height - p.y / 96});
        }
    }
    return result;
}

/// A pixel of a drawing, its row counted from below.
struct Pixel {
    int x = 0, y = 0, red = 0, green = 0, blue = 0;
};
/// Pixels of a PNG file within a distance of a place, read back by gnuplot, which selects rows
/// counted from above and prints them counted from below.
std::vector<Pixel> pixels_about(const std::filesystem::path& png, int height, int x, int y,
                                int reach) {
    const int row = height - 1 - y;
    const TemporaryFolder folder;
    const auto table = folder.path() / "pixels";
    const std::string command = fmt::format(
        "gnuplot -e \"set table '{}'; plot '{}' binary filetype=png every 1:1:{}:{}:{}:{} with "
        "rgbimage\" 2>/dev/null",
        table.string(), png.string(), x - reach, row - reach, x + reach, row + reach);
    EXPECT_EQ(std::system(command.c_str()), 0);
    std::istringstream lines(content_of(table));
    std::vector<Pixel> pixels;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        if (Pixel p; words >> p.x >> p.y >> p.red >> p.green >> p.blue) {
            pixels.push_back(p);
        }
    }
    return pixels;
}

TEST(SymbolsOnPaper, AreFilledWhereTheyShouldBeAndKeepTheirShape) {
    const TemporaryFolder folder;
    const Figure figure = every_symbol();
    draw(figure, folder.path());
    for (const std::string extension : {".svg", ".png", ".pdf"}) {
        EXPECT_GT(std::filesystem::file_size(folder.path() / ("symbols" + extension)), 3000u);
    }
    const std::string svg = content_of(folder.path() / "symbols.svg");
    const Page page = page_of(figure);
    constexpr double pixel = 1.0 / 96;
    for (const Curve& curve : figure.panels.front().curves) {
        const auto polygons = polygons_of(svg, curve.colour, page.height);
        const SymbolDrawing drawing = drawing_of(curve.symbol);
        // Each piece once in the axes and, for some, once more in the key.
        ASSERT_EQ(polygons.size(), drawing.fills.size() * (curve.in_key ? 2 : 1)) << curve.colour;
        const PaperPoint place = page.panels.front().at(curve.x[0], curve.y[0]);
        for (std::size_t k = 0; k < drawing.fills.size(); ++k) {
            const Moments expected = moments(drawing.fills[k]), found = moments(polygons[k]);
            // Symbols have the area (0.1 inch)^2. The page is rounded to whole pixels.
            EXPECT_NEAR(found.area, 0.01 * expected.area, 0.02 * 0.01 * expected.area);
            EXPECT_NEAR(found.x, place.x + 0.1 * expected.x, 0.6 * pixel);
            EXPECT_NEAR(found.y, place.y + 0.1 * expected.y, 0.6 * pixel);
            const auto [least, greatest] = extent_in_y({polygons[k]});
            const auto [from, to] = extent_in_y({drawing.fills[k]});
            EXPECT_NEAR(greatest - least, 0.1 * (to - from), 0.1 * pixel);
        }
    }
}

TEST(SymbolsOnPaper, AreHalfFilledInPixelsToo) {
    const TemporaryFolder folder;
    const Figure figure = every_symbol();
    draw(figure, folder.path());
    const Page page = page_of(figure);
    const int height = static_cast<int>(std::lround(160 * page.height));
    for (const Curve& curve : figure.panels.front().curves) {
        if (curve.symbol.shape != Shape::circle) {
            continue;
        }
        const PaperPoint place = page.panels.front().at(curve.x[0], curve.y[0]);
        // 160 pixels to the inch; the circle's radius is 9 of them, its edge and bar 2 wide.
        const int x = static_cast<int>(std::lround(160 * place.x)),
                  y = static_cast<int>(std::lround(160 * place.y));
        int upper = 0, lower = 0;
        for (const Pixel& p : pixels_about(folder.path() / "symbols.png", height, x, y, 6)) {
            const bool coloured = std::abs(p.red - channel(curve.colour, 0)) < 20 &&
                                  std::abs(p.green - channel(curve.colour, 1)) < 20;
            const bool inside = std::hypot(p.x - x, p.y - y) < 6 && std::abs(p.x - x) >= 2;
            (p.y > y ? upper : lower) += coloured && inside && std::abs(p.y - y) >= 2;
        }
        const Filling filling = curve.symbol.filling;
        const auto full = [](int count) { return count >= 25; };
        const auto clear = [](int count) { return count <= 2; };
        if (filling == Filling::filled) {
            EXPECT_TRUE(full(upper) && full(lower)) << upper << ' ' << lower;
        } else if (filling == Filling::bottom_half) {
            EXPECT_TRUE(clear(upper) && full(lower)) << upper << ' ' << lower;
        } else if (filling == Filling::top_half) {
            EXPECT_TRUE(full(upper) && clear(lower)) << upper << ' ' << lower;
        } else if (filling == Filling::hollow) {
            EXPECT_TRUE(clear(upper) && clear(lower)) << upper << ' ' << lower;
        } else {
            EXPECT_TRUE(!clear(upper) && !full(upper)) << upper << ' ' << lower;
        }
    }
}

TEST(Layout, HoldsTheLineAtZero) {
    const Panel below{.curves = {{.x = {1, 2}, .y = {-2, -1}}}, .zero_line = true};
    const Page page = page_of({.name = "", .title = "", .panels = {below}});
    EXPECT_GE(page.panels[0].y.second, 0) << "the line would cross the title";
}

}  // namespace reports_symbols_test
