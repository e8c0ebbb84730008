#include "reports/ink.h"

#include <fmt/format.h>

#include <cmath>

#include "reports/figure.h"
#include "reports/text_width.h"

namespace pendular {
namespace {

constexpr double edge_width = 1.2;

/// Outline of a symbol of area 1 about the origin, scaled to `area` [inch^2] and moved to `place`.
Outline placed(Outline outline, PaperPoint place, double area) {
    const double size = std::sqrt(area);
    for (auto& p : outline) {
        p = {place.x + size * p.x, place.y + size * p.y};
    }
    return outline;
}

}  // namespace

void Ink::add(const std::string& style, Outline points) {
    if (layers_.empty() || layers_.back().style != style) {
        layers_.push_back({style, {}});
    }
    layers_.back().pieces.push_back(std::move(points));
}

void Ink::line(Outline points, const Pen& pen) {
    add(fmt::format("lines linewidth {} linecolor rgb '{}' dashtype {}", pen.width, pen.colour,
                    pen.dash),
        std::move(points));
}

void Ink::area(Outline closed, const std::string& colour, double opacity) {
    add(fmt::format(
            "filledcurves closed fillcolor rgb '{}' fillstyle transparent solid {} noborder",
            colour, opacity),
        std::move(closed));
}

void Ink::label(const std::string& text, PaperPoint place, const std::string& options) {
    labels_.push_back(fmt::format("set label {} {} at first {},{} {} front\n", labels_.size() + 1,
                                  gnuplot_string(text), place.x, place.y, options));
}

void Ink::text(const std::string& text, PaperPoint place, bool end_there) {
    label(text, place, end_there ? "right" : "left");
}

void Ink::centred(const std::string& text, PaperPoint place) {
    label(text, place, "center");
}

void Ink::title(const std::string& text, PaperPoint place) {
    label(text, place, fmt::format("center font ',{}'", title_size));
}

void Ink::symbol(const Symbol& symbol, PaperPoint place, double area, const std::string& colour) {
    const SymbolDrawing drawing = drawing_of(symbol);
    for (const auto& fill : drawing.fills) {
        this->area(placed(fill, place, area), colour);
    }
    for (const auto& stroke : drawing.strokes) {
        line(placed(stroke, place, area), {colour, edge_width});
    }
}

std::string Ink::data_blocks() const {
    std::string text;
    for (std::size_t k = 0; k < layers_.size(); ++k) {
        text += fmt::format("$ink{} << EOD\n", k);
        for (const auto& piece : layers_[k].pieces) {
            for (const auto& p : piece) {
                text += fmt::format("{:.5f} {:.5f}\n", p.x, p.y);
            }
            text += '\n';
        }
        text += "EOD\n";
    }
    return text;
}

std::string Ink::script(double width, double height) const {
    std::string text = fmt::format(
        "unset object\nunset arrow\nunset logscale\nunset key\nunset border\nunset tics\nunset "
        "grid\nunset xlabel\nunset ylabel\nset lmargin at screen 0\nset rmargin at screen 1\nset "
        "bmargin at screen 0\nset tmargin at screen 1\nset xrange [0:{}]\nset yrange [0:{}]\n",
        width, height);
    for (const auto& label : labels_) {
        text += label;
    }
    std::string terms = "NaN";
    for (std::size_t k = 0; k < layers_.size(); ++k) {
        terms += fmt::format(", $ink{} using 1:2 with {}", k, layers_[k].style);
    }
    return text + fmt::format("plot {}\nunset label\n", terms);
}

}  // namespace pendular
