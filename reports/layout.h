#pragma once

#include <string>
#include <utility>
#include <vector>

#include "reports/figure.h"

namespace pendular {

/// Least and greatest value on an axis.
using AxisRange = std::pair<double, double>;

/// Position of a panel's axes on the page, and the ranges of values that they span.
struct PanelPlace {
    double left = 0, right = 0, bottom = 0, top = 0;  ///< edges of the axes on the page [inch]
    AxisRange x, y;
    bool log_x = false, log_y = false;

    /// Position of the values (x, y) on the page [inch].
    PaperPoint at(double value_x, double value_y) const;
};

/// Line height of the labels below an x axis [inch].
constexpr double name_line = 0.19;

/// Layout of a figure's page. Every position is known before the figure is drawn, so that symbols
/// and key can be drawn in inches and keep their shape.
struct Page {
    double width = 0, height = 0;  ///< [inch]
    std::string title;             ///< title with line ends where it is wider than the page
    std::vector<PanelPlace> panels;
};
/// Lays out the panels and the title of a figure on a page.
Page page_of(const Figure& figure);

}  // namespace pendular
