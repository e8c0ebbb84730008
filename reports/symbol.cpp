#include "reports/symbol.h"

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/linestring.hpp>
#include <boost/geometry/geometries/multi_linestring.hpp>
#include <boost/geometry/geometries/multi_polygon.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <cmath>
#include <numbers>

namespace pendular {
namespace {

namespace geometry = boost::geometry;
using Point = geometry::model::d2::point_xy<double>;
using Polygon = geometry::model::polygon<Point>;
using Line = geometry::model::linestring<Point>;

constexpr double far_away = 10;  ///< coordinate outside every symbol of area 1

Outline outline_of(const auto& points) {
    Outline outline;
    for (const Point& p : points) {
        outline.push_back({p.x(), p.y()});
    }
    return outline;
}

/// Polygon with corners on a circle of radius 1, the first at `first_angle` [rad]. Every second
/// corner is at the radius `inner_share`.
Polygon corners(int count, double first_angle, double inner_share = 1) {
    Polygon polygon;
    for (int k = 0; k < count; ++k) {
        const double angle = first_angle + 2 * std::numbers::pi * k / count;
        const double radius = k % 2 == 0 ? 1 : inner_share;
        geometry::append(polygon, Point(radius * std::cos(angle), radius * std::sin(angle)));
    }
    geometry::correct(polygon);
    return polygon;
}

/// Edge of a shape as a polygon with its centre of area at the origin; its size is arbitrary.
Polygon edge_of(Shape shape) {
    constexpr double up = std::numbers::pi / 2;
    switch (shape) {
        case Shape::square:
            return corners(4, up / 2);
        case Shape::triangle:
            return corners(3, up);
        case Shape::star:
            return corners(10, up, 0.45);
        case Shape::downward_triangle:
            return corners(3, -up);
        case Shape::diamond:
            return corners(4, up);
        case Shape::circle:
        case Shape::plus:
            break;
    }
    return corners(48, up);
}

Polygon with_unit_area(const Polygon& polygon) {
    const double factor = 1 / std::sqrt(geometry::area(polygon));
    Polygon result;
    geometry::transform(
        polygon, result,
        geometry::strategy::transform::scale_transformer<double, 2, 2>(factor, factor));
    return result;
}

/// Part of a polygon below half its height (`lower`) or above it, in one or more pieces: the lower
/// half of a star has two.
std::vector<Outline> half(const Polygon& polygon, bool lower) {
    using Box = geometry::model::box<Point>;
    const auto bounds = geometry::return_envelope<Box>(polygon);
    const double middle = (bounds.min_corner().y() + bounds.max_corner().y()) / 2;
    const Box side(Point(-far_away, lower ? -far_away : middle),
                   Point(far_away, lower ? middle : far_away));
    geometry::model::multi_polygon<Polygon> pieces;
    geometry::intersection(polygon, side, pieces);
    std::vector<Outline> result;
    for (const Polygon& piece : pieces) {
        result.push_back(outline_of(piece.outer()));
    }
    return result;
}

/// Two diagonal lines through the centre of a polygon, from edge to edge.
std::vector<Outline> cross(const Polygon& polygon) {
    std::vector<Outline> result;
    for (const double slope : {1.0, -1.0}) {
        const Line diagonal{Point(-far_away, -far_away * slope), Point(far_away, far_away * slope)};
        geometry::model::multi_linestring<Line> inside;
        geometry::intersection(diagonal, polygon, inside);
        for (const Line& line : inside) {
            result.push_back(outline_of(line));
        }
    }
    return result;
}

}  // namespace

SymbolDrawing drawing_of(const Symbol& symbol) {
    if (symbol.shape == Shape::plus) {
        constexpr double arm = 0.9;  // a triangle of area 1 reaches up to 0.88
        return {.fills = {}, .strokes = {{{-arm, 0}, {arm, 0}}, {{0, -arm}, {0, arm}}}};
    }
    const Polygon edge = with_unit_area(edge_of(symbol.shape));
    SymbolDrawing drawing{.fills = {}, .strokes = {outline_of(edge.outer())}};
    switch (symbol.filling) {
        case Filling::filled:
            drawing.fills = drawing.strokes;
            break;
        case Filling::bottom_half:
            drawing.fills = half(edge, true);
            break;
        case Filling::top_half:
            drawing.fills = half(edge, false);
            break;
        case Filling::crossed:
            for (auto& line : cross(edge)) {
                drawing.strokes.push_back(std::move(line));
            }
            break;
        case Filling::hollow:
            break;
    }
    return drawing;
}

Shape shape_of(double friction) {
    return std::ranges::min(
               friction_code, {},
               [&](const FrictionCode& code) { return std::abs(code.friction - friction); })
        .shape;
}

const ContentCode& code_of(double liquid_content) {
    if (liquid_content <= 0) {
        return dry_code;
    }
    return *std::ranges::min_element(content_code, {}, [&](const ContentCode& code) {
        return std::abs(std::log(code.liquid_content / liquid_content));
    });
}

Symbol simulated_symbol(double friction, double liquid_content) {
    return {shape_of(friction), code_of(liquid_content).filling};
}

}  // namespace pendular
