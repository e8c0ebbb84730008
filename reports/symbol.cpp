#include "reports/symbol.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pendular {
namespace {

/// Closed outline, clockwise, with corners on a circle of radius 1, the first at `first_angle`
/// [rad]. Every second corner is at the radius `inner_share`.
Outline corners(int count, double first_angle, double inner_share = 1) {
    Outline outline;
    for (int k = count; k >= 0; --k) {
        const int corner = k % count;
        const double angle = first_angle + 2 * std::numbers::pi * corner / count;
        const double radius = corner % 2 == 0 ? 1 : inner_share;
        outline.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    return outline;
}

/// Edge of a shape with its centre of area at the origin; its size is arbitrary. Every ray from
/// the centre crosses it once.
Outline edge_of(Shape shape) {
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

Outline with_unit_area(Outline outline) {
    double twice_area = 0;
    for (std::size_t k = 1; k < outline.size(); ++k) {
        const PaperPoint &from = outline[k - 1], &to = outline[k];
        twice_area += from.y * to.x - from.x * to.y;
    }
    const double factor = 1 / std::sqrt(twice_area / 2);
    for (PaperPoint& p : outline) {
        p = {factor * p.x, factor * p.y};
    }
    return outline;
}

/// Part of a closed outline below half its height (`lower`) or above it. Were it in pieces, they
/// would be joined along the cut, which changes no area.
Outline half(const Outline& outline, bool lower) {
    const auto [lowest, highest] = std::ranges::minmax(outline, {}, &PaperPoint::y);
    const double middle = (lowest.y + highest.y) / 2;
    const auto belongs = [&](const PaperPoint& p) { return lower ? p.y <= middle : p.y >= middle; };
    Outline part;
    for (std::size_t k = 1; k < outline.size(); ++k) {
        const PaperPoint &from = outline[k - 1], &to = outline[k];
        if (belongs(from)) part.push_back(from);
        if (belongs(from) == belongs(to)) continue;
        const double share = (middle - from.y) / (to.y - from.y);
        part.push_back({from.x + share * (to.x - from.x), middle});
    }
    part.push_back(part.front());
    return part;
}

/// Two diagonal lines through the centre of a closed outline, from edge to edge.
std::vector<Outline> cross(const Outline& outline) {
    std::vector<Outline> result;
    for (const double slope : {1.0, -1.0}) {
        const auto height = [&](const PaperPoint& p) { return p.y - slope * p.x; };
        std::vector<double> ends;  // x where the diagonal crosses the edge
        for (std::size_t k = 1; k < outline.size(); ++k) {
            const PaperPoint &from = outline[k - 1], &to = outline[k];
            if ((height(from) < 0) == (height(to) < 0)) continue;
            const double share = height(from) / (height(from) - height(to));
            ends.push_back(from.x + share * (to.x - from.x));
        }
        const auto [left, right] = std::ranges::minmax(ends);
        result.push_back({{left, slope * left}, {right, slope * right}});
    }
    return result;
}

}  // namespace

SymbolDrawing drawing_of(const Symbol& symbol) {
    if (symbol.shape == Shape::plus) {
        constexpr double arm = 0.9;  // a triangle of area 1 reaches up to 0.88
        return {.fills = {}, .strokes = {{{-arm, 0}, {arm, 0}}, {{0, -arm}, {0, arm}}}};
    }
    const Outline edge = with_unit_area(edge_of(symbol.shape));
    SymbolDrawing drawing{.fills = {}, .strokes = {edge}};
    switch (symbol.filling) {
        case Filling::filled:
            drawing.fills = drawing.strokes;
            break;
        case Filling::bottom_half:
            drawing.fills = {half(edge, true)};
            break;
        case Filling::top_half:
            drawing.fills = {half(edge, false)};
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
