#include "reports/layout.h"

#include <algorithm>
#include <cmath>

namespace pendular {
namespace {

// All lengths are in inches.
constexpr double symbol_area = 0.1 * 0.1;
constexpr double cap = 0.035;  ///< half the width of an error bar's ends
constexpr double line_spacing = 0.21;
constexpr double sample_width = 0.34, sample_gap = 0.1, key_inset = 0.14;

void draw_bar(Ink& ink, const PanelPlace& place, double x, double y, double error,
              const std::string& colour) {
    const PaperPoint low = place.at(x, y - error), high = place.at(x, y + error);
    const Pen pen{colour, 1};
    ink.line({low, high}, pen);
    for (const auto& end : {low, high}) {
        ink.line({{end.x - cap, end.y}, {end.x + cap, end.y}}, pen);
    }
}

void draw_points(Ink& ink, const PanelPlace& place, const Curve& curve) {
    for (std::size_t k = 0; k < curve.x.size(); ++k) {
        if (!curve.y_error.empty() && curve.y_error[k] > 0) {
            draw_bar(ink, place, curve.x[k], curve.y[k], curve.y_error[k], curve.colour);
        }
    }
    for (std::size_t k = 0; k < curve.x.size(); ++k) {
        ink.symbol(curve.symbol, place.at(curve.x[k], curve.y[k]), symbol_area * curve.area,
                   curve.colour);
    }
}

constexpr double bar_opacity = 0.55;
constexpr double bar_width = 0.62;  ///< width of a bar in units of the x axis

/// Height on the page [inch] of a text above a bar that ends at `top` [inch], clear of the panel's
/// horizontal reference lines.
double above_bar(const PanelPlace& place, const Panel& panel, double top) {
    constexpr double half_line = 0.11;
    double height = top + half_line;
    for (const auto& reference : panel.references) {
        const double line = place.at(place.x.first, reference.value).y;
        if (!reference.vertical && std::abs(line - height) < half_line) {
            height = line + half_line;
        }
    }
    return height;
}

/// Draws the bars of a curve from the x axis up, with a text above each bar.
void draw_bars(Ink& ink, const PanelPlace& place, const Panel& panel, const Curve& curve) {
    for (std::size_t k = 0; k < curve.x.size(); ++k) {
        const double begin = curve.from.empty() ? place.y.first : curve.from[k];
        const PaperPoint low = place.at(curve.x[k] - bar_width / 2, std::min(begin, curve.y[k])),
                         high = place.at(curve.x[k] + bar_width / 2, std::max(begin, curve.y[k]));
        const Outline edge{low, {high.x, low.y}, high, {low.x, high.y}, low};
        ink.area(edge, curve.colour, bar_opacity);
        ink.line(edge, {curve.colour, 1.2});
        if (k < curve.names.size()) {
            // The text stands at the end of the bar, which is below where the bar hangs.
            constexpr double half_line = 0.11;
            const bool hangs = begin > curve.y[k];
            ink.centred(curve.names[k],
                        {(low.x + high.x) / 2,
                         hangs ? low.y - half_line : above_bar(place, panel, high.y)});
        }
    }
}

/// Draws horizontal bars of a curve from x = 0 on, one in each row. A bar that would leave the axes
/// ends there without an edge, with its name inside the end.
void draw_bars_across(Ink& ink, const PanelPlace& place, const Curve& curve) {
    for (std::size_t k = 0; k < curve.x.size(); ++k) {
        const double end = std::clamp(curve.x[k], place.x.first, place.x.second);
        const bool cut = end != curve.x[k];
        const PaperPoint low = place.at(0, curve.y[k] - bar_width / 2),
                         high = place.at(end, curve.y[k] + bar_width / 2);
        const Outline edge{low, {high.x, low.y}, high, {low.x, high.y}, low};
        ink.area(edge, curve.colour, bar_opacity);
        ink.line(cut ? Outline{{high.x, low.y}, low, {low.x, high.y}, high} : edge,
                 {curve.colour, 1});
        if (cut && k < curve.names.size()) {
            constexpr double inset = 0.06;
            ink.text(curve.names[k], {high.x + (end > 0 ? -inset : inset), (low.y + high.y) / 2},
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

/// Entry of a key: a text and the curve or reference line whose style it explains.
struct Entry {
    const std::string* label;
    const Curve* curve = nullptr;  ///< null: a reference line, drawn in `colour`
    std::string colour = {};
};

std::vector<Entry> entries_of(const Panel& panel) {
    std::vector<Entry> entries;
    for (const auto& reference : panel.references) {
        if (!reference.label.empty()) {
            entries.push_back({&reference.label, nullptr, reference.colour});
        }
    }
    for (const auto& curve : panel.curves) {
        if (curve.in_key) {
            entries.push_back({&curve.label, &curve});
        }
    }
    return entries;
}

/// Draws the sample of line or symbol of a key's entry, centred on `middle`.
void draw_sample(Ink& ink, const Entry& entry, PaperPoint middle) {
    const double reach = sample_width / 2, y = middle.y;
    const Outline stroke{{middle.x - reach, y}, {middle.x + reach, y}};
    if (!entry.curve) {
        ink.line(stroke, {entry.colour, reference_pen.width, reference_pen.dash});
        return;
    }
    const Curve& curve = *entry.curve;
    constexpr double half_band = 0.055;
    switch (curve.style) {
        case Curve::Style::points:
            ink.symbol(curve.symbol, middle, symbol_area * curve.area, curve.colour);
            break;
        case Curve::Style::line:
        case Curve::Style::dotted_line:
        case Curve::Style::dashed_line:
            ink.line(stroke, pen_of(curve));
            break;
        case Curve::Style::band:
        case Curve::Style::bars:
        case Curve::Style::bars_across:
        case Curve::Style::cells:
            ink.area({{middle.x - reach, y - half_band},
                      {middle.x + reach, y - half_band},
                      {middle.x + reach, y + half_band},
                      {middle.x - reach, y + half_band}},
                     curve.colour, curve.style == Curve::Style::band ? band_opacity : bar_opacity);
            break;
    }
}

/// Covers the room above the data, which is kept free for a key, so that no reference line or grid
/// crosses the key's texts.
void clear_headroom(Ink& ink, const PanelPlace& place, const Panel& panel, std::size_t entries) {
    constexpr double frame = 0.02;
    const double height = std::min(line_spacing * static_cast<double>(entries) + key_inset,
                                   panel.headroom * (place.top - place.bottom));
    const double left = place.left + frame, right = place.right - frame;
    const double top = place.top - frame, bottom = place.top - height;
    ink.area({{left, bottom}, {right, bottom}, {right, top}, {left, top}}, "#ffffff");
}

/// Draws the key of a panel. The samples are at the outer edge and the texts run inwards, so that
/// the width of the texts need not be known.
void draw_key(Ink& ink, const PanelPlace& place, const Panel& panel) {
    const auto entries = entries_of(panel);
    const bool right = panel.key == Key::top_right || panel.key == Key::bottom_right;
    const bool bottom = panel.key == Key::bottom_left || panel.key == Key::bottom_right;
    const double edge = panel.key == Key::outside ? place.right
                        : right                   ? place.right - key_inset
                                                  : place.left;
    const double inset = right ? 0 : key_inset;
    const double x = right ? edge - sample_width / 2 : edge + inset + sample_width / 2;
    const double away = sample_width / 2 + sample_gap;
    if (panel.headroom > 0 && (panel.key == Key::top_left || panel.key == Key::top_right)) {
        clear_headroom(ink, place, panel, entries.size());
    }
    double y = bottom ? place.bottom + line_spacing * static_cast<double>(entries.size()) -
                            line_spacing / 2 + key_inset / 2
                      : place.top - line_spacing / 2 - key_inset / 2;
    for (const auto& entry : entries) {
        draw_sample(ink, entry, {x, y});
        ink.text(*entry.label, {right ? x - away : x + away, y}, right);
        y -= line_spacing;
    }
}

}  // namespace

Pen pen_of(const Curve& curve) {
    switch (curve.style) {
        case Curve::Style::dotted_line:
            return {curve.colour, 1.5 * curve.weight, "(2,3)"};
        case Curve::Style::dashed_line:
            return {curve.colour, 1.1 * curve.weight, "(10,4,2,4)"};
        default:
            return {curve.colour, 1.8 * curve.weight};
    }
}

Ink marks_of(const Figure& figure, const Page& page) {
    Ink ink;
    for (std::size_t p = 0; p < figure.panels.size(); ++p) {
        const Panel& panel = figure.panels[p];
        for (const auto& curve : panel.curves) {
            if (curve.style == Curve::Style::points) {
                draw_points(ink, page.panels[p], curve);
            } else if (curve.style == Curve::Style::bars) {
                draw_bars(ink, page.panels[p], panel, curve);
            } else if (curve.style == Curve::Style::bars_across) {
                draw_bars_across(ink, page.panels[p], curve);
            } else if (curve.style == Curve::Style::cells) {
                draw_cells(ink, page.panels[p], curve);
            }
        }
        draw_names(ink, page.panels[p], panel);
        if (panel.key != Key::none) {
            draw_key(ink, page.panels[p], panel);
        }
    }
    return ink;
}

}  // namespace pendular
