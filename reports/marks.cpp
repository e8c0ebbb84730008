#include "reports/layout.h"

#include <algorithm>
#include <cmath>

#include "reports/text_width.h"

namespace pendular {
namespace {

// All lengths are in inches.
constexpr double cap = 0.03;        ///< half the width of an error bar's ends
constexpr double half_line = 0.09;  ///< of text

/// Draws an error bar from `low` to `high`, cut at the edges of the axes: on a logarithmic axis, a
/// value less its error may not be positive.
void draw_bar(Ink& ink, PaperPoint low, PaperPoint high, bool across, const std::string& colour) {
    const Pen pen{colour, 1};
    ink.line({low, high}, pen);
    const double x = across ? 0 : cap, y = across ? cap : 0;
    for (const auto& end : {low, high}) {
        ink.line({{end.x - x, end.y - y}, {end.x + x, end.y + y}}, pen);
    }
}

void draw_bars(Ink& ink, const PanelPlace& place, const Curve& curve, std::size_t k) {
    const double x = curve.x[k], y = curve.y[k];
    if (k < curve.y_error.size() && curve.y_error[k] > 0) {
        const double least = std::max(y - curve.y_error[k], place.y.first);
        draw_bar(ink, place.at(x, least), place.at(x, y + curve.y_error[k]), false, curve.colour);
    }
    if (k < curve.x_error.size() && curve.x_error[k] > 0) {
        const double least = std::max(x - curve.x_error[k], place.x.first);
        draw_bar(ink, place.at(least, y), place.at(x + curve.x_error[k], y), true, curve.colour);
    }
}

/// Place of the text of a point: above it or, where a horizontal reference line would cross the
/// text, below it or farther above.
PaperPoint beside_point(const PanelPlace& place, const Panel& panel, PaperPoint point) {
    for (const double away : {0.17, -0.17, 0.3}) {
        const double y = point.y + away;
        const bool crossed = std::ranges::any_of(panel.references, [&](const Reference& r) {
            return !r.vertical && std::abs(place.at(place.x.first, r.value).y - y) < half_line;
        });
        if (!crossed && y - half_line > place.bottom) return {point.x, y};
    }
    return {point.x, point.y + 0.17};
}

void draw_points(Ink& ink, const PanelPlace& place, const Panel& panel, const Curve& curve) {
    for (std::size_t k = 0; k < curve.x.size(); ++k) {
        draw_bars(ink, place, curve, k);
    }
    for (std::size_t k = 0; k < curve.x.size(); ++k) {
        const PaperPoint at = place.at(curve.x[k], curve.y[k]);
        ink.symbol(curve.symbol, at, symbol_area * curve.area, curve.colour);
        if (k < curve.names.size()) ink.centred(curve.names[k], beside_point(place, panel, at));
    }
}

constexpr double bar_width = 0.62;  ///< width of a bar in units of the axis of rows

/// Place of the text in the end of a bar that is cut off, as near to the end as the points in its
/// row leave room.
PaperPoint text_in_bar(const PanelPlace& place, const Panel& panel, const std::string& text,
                       double row, bool rightward) {
    constexpr double inset = 0.06, beside_symbol = 0.09;
    const double width = text_width(text), sign = rightward ? -1 : 1;
    double from = (rightward ? place.right : place.left) + sign * inset;
    for (bool moved = true; moved;) {
        moved = false;
        const double low = std::min(from, from + sign * width),
                     high = std::max(from, from + sign * width);
        for (const Curve& curve : panel.curves) {
            for (std::size_t k = 0; k < curve.x.size(); ++k) {
                if (curve.style != Curve::Style::points || curve.y[k] != row) continue;
                const double at = place.at(curve.x[k], row).x;
                if (at < low - beside_symbol || at > high + beside_symbol) continue;
                from = at + sign * 1.5 * beside_symbol;
                moved = true;
            }
        }
    }
    return {from, place.at(place.x.first, row).y};
}

/// Draws horizontal bars of a curve from x = 0 on, one in each row. A bar that would leave the axes
/// ends there without an edge, with its name inside the end.
void draw_bars_across(Ink& ink, const PanelPlace& place, const Panel& panel, const Curve& curve) {
    for (std::size_t k = 0; k < curve.x.size(); ++k) {
        const double end = std::clamp(curve.x[k], place.x.first, place.x.second);
        const bool cut = end != curve.x[k];
        const double begin = place.log_x ? place.x.first : 0;
        const PaperPoint low = place.at(begin, curve.y[k] - bar_width / 2),
                         high = place.at(end, curve.y[k] + bar_width / 2);
        const Outline edge{low, {high.x, low.y}, high, {low.x, high.y}, low};
        ink.area(edge, curve.colour, bar_opacity);
        ink.line(cut ? Outline{{high.x, low.y}, low, {low.x, high.y}, high} : edge,
                 {curve.colour, 1});
        if (cut && k < curve.names.size()) {
            ink.text(curve.names[k], text_in_bar(place, panel, curve.names[k], curve.y[k], end > 0),
                     end > 0);
        }
    }
}

/// Draws the squares of a curve about its points, with a text in each.
void draw_cells(Ink& ink, const PanelPlace& place, const Curve& curve) {
    constexpr double strongest = 0.6;  // so that a black text stays readable
    for (std::size_t k = 0; k < curve.x.size(); ++k) {
        const PaperPoint low = place.at(curve.x[k] - 0.5, curve.y[k] - 0.5),
                         high = place.at(curve.x[k] + 0.5, curve.y[k] + 0.5);
        const Outline edge{low, {high.x, low.y}, high, {low.x, high.y}, low};
        ink.area(edge, curve.colour, strongest * curve.shade[k]);
        ink.line(edge, {"#ffffff", 1});
        if (k < curve.names.size()) {
            ink.centred(curve.names[k], {(low.x + high.x) / 2, (low.y + high.y) / 2});
        }
    }
}

void draw_names(Ink& ink, const PanelPlace& place, const Panel& panel) {
    for (std::size_t k = 0; k < panel.x_names.size(); ++k) {
        PaperPoint at = place.at(static_cast<double>(k) + 1, place.y.first);
        at = {at.x, place.bottom - 0.04 - name_line / 2};
        for (const auto& line : panel.x_names[k]) {
            ink.centred(line, at);
            at.y -= name_line;
        }
    }
    for (std::size_t k = 0; k < panel.y_names.size(); ++k) {
        const PaperPoint row = place.at(place.x.first, static_cast<double>(k) + 1);
        ink.text(panel.y_names[k], {place.left - 0.08, row.y}, true);
    }
}

void draw_title(Ink& ink, const Page& page) {
    constexpr double line = 0.21, above = 0.06;
    for (std::size_t k = 0; k < page.title.size(); ++k) {
        const double depth = above + line * (static_cast<double>(k) + 0.5);
        ink.title(page.title[k], {page.width / 2, page.height - depth});
    }
}

}  // namespace

Ink marks_of(const Figure& figure, const Page& page) {
    Ink ink;
    draw_title(ink, page);
    for (std::size_t p = 0; p < figure.panels.size(); ++p) {
        const Panel& panel = figure.panels[p];
        for (const auto& curve : panel.curves) {
            if (!curve.drawn) continue;
            if (curve.style == Curve::Style::points) {
                draw_points(ink, page.panels[p], panel, curve);
            } else if (curve.style == Curve::Style::bars_across) {
                draw_bars_across(ink, page.panels[p], panel, curve);
            } else if (curve.style == Curve::Style::cells) {
                draw_cells(ink, page.panels[p], curve);
            }
        }
        draw_names(ink, page.panels[p], panel);
        if (!panel.heading.empty()) {
            const PanelPlace& place = page.panels[p];
            ink.centred(panel.heading,
                        {(place.left + place.right) / 2, place.top + heading_line / 2});
        }
    }
    for (const KeyPlace& key : page.keys) {
        draw_key(ink, figure.panels[key.panel], key.layout, key.corner);
    }
    return ink;
}

}  // namespace pendular
