#include "reports/figure_script.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "reports/pens.h"
#include "reports/tics.h"

namespace pendular {
namespace {

std::string block_name(std::size_t panel, std::size_t curve) {
    return fmt::format("$d{}_{}", panel, curve);
}

/// Gnuplot commands that draw a reference line behind the data, with its error as a shaded band.
std::string reference_object(const Reference& r, int number, const PanelPlace& place) {
    const auto [x, y] = std::pair(place.x, place.y);
    std::string text;
    if (r.error > 0) {
        const auto [x1, x2] = r.vertical ? std::pair(r.value - r.error, r.value + r.error) : x;
        const auto [y1, y2] = r.vertical ? y : std::pair(r.value - r.error, r.value + r.error);
        text += fmt::format(
            "set object {} rectangle from first {},{} to {},{} behind fillcolor rgb '{}' "
            "fillstyle solid 0.18 noborder\n",
            number, std::max(x1, x.first), std::max(y1, y.first), std::min(x2, x.second),
            std::min(y2, y.second), r.colour);
    }
    const auto [a, b] = r.vertical ? std::pair(r.value, r.value) : x;
    const auto [c, d] = r.vertical ? y : std::pair(r.value, r.value);
    text += fmt::format(
        "set arrow {} from first {},{} to {},{} nohead back linewidth {} dashtype {} "
        "linecolor rgb '{}'\n",
        number, a, c, b, d, reference_pen.width, reference_pen.dash, r.colour);
    return text;
}

std::string plot_term(const Curve& curve, const std::string& block) {
    if (curve.style == Curve::Style::band) {
        return fmt::format(
            "{} using 1:3:4 with filledcurves fillcolor rgb '{}' fillstyle transparent solid {} "
            "noborder",
            block, curve.colour, band_opacity);
    }
    const Pen pen = pen_of(curve);
    return fmt::format("{} using 1:2 with lines linewidth {} dashtype {} linecolor rgb '{}'", block,
                       pen.width, pen.dash, pen.colour);
}

/// Gnuplot commands for the axes of a panel and for their position on the page.
std::string axes_script(const Panel& panel, const PanelPlace& place, const Page& page) {
    constexpr double tall = 100;  // numbers above one another do not touch
    std::string text =
        "unset object\nunset arrow\nunset logscale\nunset key\nset format x '%g'\n"
        "set border 31 linewidth 1.2\nset grid xtics ytics linecolor rgb '#e4e4e4'\n"
        "set ytics nomirror autofreq format '% h'\n";
    if (panel.log_y) {
        constexpr double decades = 100;  // from here on, powers of ten are enough
        text += place.y.second > decades * place.y.first
                    ? "set logscale y\nset ytics format '10^{%T}'\n"
                    : "set logscale y\nset ytics (" + tics_of_logarithm(place.y, tall) +
                          ") format '%g'\n";
    }
    if (!panel.y_names.empty()) text += "unset ytics\n";
    if (!panel.x_names.empty()) {
        text += "unset xtics\n";
    } else if (panel.log_x) {
        text += "set logscale x\nset xtics nomirror (" +
                tics_of_logarithm(place.x, place.right - place.left) + ")\n";
    } else {
        text += fmt::format("set xtics nomirror {:.6g}\n",
                            step_of_tics(place.x, place.right - place.left));
    }
    text += fmt::format("set xlabel {}\nset ylabel {}\n", gnuplot_string(panel.x_label),
                        gnuplot_string(panel.y_label));
    text += fmt::format("set xrange [{}:{}]\nset yrange [{}:{}]\n", place.x.first, place.x.second,
                        place.y.first, place.y.second);
    return text + fmt::format(
                      "set lmargin at screen {}\nset rmargin at screen {}\nset bmargin at screen "
                      "{}\nset tmargin at screen {}\n",
                      place.left / page.width, place.right / page.width, place.bottom / page.height,
                      place.top / page.height);
}

std::string panel_script(const Figure& figure, std::size_t p, const Page& page) {
    const Panel& panel = figure.panels[p];
    const PanelPlace& place = page.panels[p];
    std::string text = axes_script(panel, place, page);
    int number = 1;
    for (const auto& reference : panel.references) {
        text += reference_object(reference, number++, place);
    }
    const auto grey_line = [&](double from, double to) {
        text += fmt::format(
            "set arrow {} from first {},{} to {},{} nohead back linecolor rgb '#888888'\n",
            number++, place.x.first, from, place.x.second, to);
    };
    if (panel.diagonal) {
        grey_line(place.x.first, place.x.second);
    }
    if (panel.zero_line) {
        grey_line(0, 0);
    }
    std::string terms = "NaN";
    for (std::size_t c = 0; c < panel.curves.size(); ++c) {
        if (has_line(panel.curves[c])) {
            terms += ", " + plot_term(panel.curves[c], block_name(p, c));
        }
    }
    return text + fmt::format("plot {}\n", terms);
}

}  // namespace

bool has_line(const Curve& curve) {
    using Style = Curve::Style;
    return curve.style != Style::points && curve.style != Style::bars_across &&
           curve.style != Style::cells && curve.style != Style::scale && curve.drawn &&
           !curve.x.empty();
}

std::string data_blocks(const Figure& figure) {
    std::string text;
    for (std::size_t p = 0; p < figure.panels.size(); ++p) {
        for (std::size_t c = 0; c < figure.panels[p].curves.size(); ++c) {
            const Curve& curve = figure.panels[p].curves[c];
            if (!has_line(curve)) {
                continue;
            }
            text += block_name(p, c) + " << EOD\n";
            for (std::size_t k = 0; k < curve.x.size(); ++k) {
                if (!std::isfinite(curve.x[k]) || !std::isfinite(curve.y[k])) {
                    text += "\n";  // a gap
                    continue;
                }
                const double stated = curve.y_error.empty() ? 0 : curve.y_error[k];
                const double error = std::isfinite(stated) ? stated : 0;
                text += fmt::format("{} {} {} {}\n", curve.x[k], curve.y[k], curve.y[k] - error,
                                    curve.y[k] + error);
            }
            text += "EOD\n";
        }
    }
    return text;
}

std::string script_of_page(const Figure& figure, const Page& page, const Ink& marks) {
    std::string text = "set multiplot\n";
    for (std::size_t p = 0; p < figure.panels.size(); ++p) {
        text += panel_script(figure, p, page);
    }
    return text + marks.script(page.width, page.height) + "unset multiplot\nunset output\n";
}

}  // namespace pendular
