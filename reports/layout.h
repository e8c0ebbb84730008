#pragma once

#include <string>
#include <utility>
#include <vector>

#include "reports/figure.h"
#include "reports/ink.h"

namespace pendular {

/// Least and greatest value on an axis, in its unit.
using AxisRange = std::pair<double, double>;

/// Place of a panel's axes on the page, with the ranges of values along them.
struct PanelPlace {
    double left = 0, right = 0, bottom = 0, top = 0;  ///< edges of the axes on the page [inch]
    AxisRange x, y;
    bool log_x = false, log_y = false;

    /// Returns the point on the page [inch] that shows the data point (value_x, value_y).
    PaperPoint at(double value_x, double value_y) const;
};

constexpr double name_line = 0.19;  ///< height of a line of names below an x axis [inch]

/// Layout of a figure's page. It is computed before gnuplot draws, so that symbols and keys can be
/// placed in inches and keep their shape.
struct Page {
    double width = 0, height = 0;  ///< [inch]
    std::string title;             ///< with line ends where it would be wider than the page
    std::vector<PanelPlace> panels;
};
Page page_of(const Figure& figure);

/// Returns the colour, width and dashes that follow from `colour`, `weight` and `style`.
Pen pen_of(const Curve& curve);
/// Line style of references. Its colour is empty, since each reference has its own.
inline const Pen reference_pen{.colour = {}, .width = 1.4, .dash = "(7,4)"};
constexpr double band_opacity = 0.16;  ///< opacity of bands of standard errors

/// Returns what is drawn above axes and lines: error bars, symbols, bars, cells, names along axes
/// and keys.
/// @param page layout of this figure (`page_of`)
Ink marks_of(const Figure& figure, const Page& page);

}  // namespace pendular
