#pragma once

#include <string>
#include <utility>
#include <vector>

#include "reports/figure.h"

namespace pendular {

/// Least and greatest value on an axis of a figure, in the unit of the axis.
using AxisRange = std::pair<double, double>;

/// Position of the axes of a panel on the page of a figure, with the ranges of values along the
/// axes.
struct PanelPlace {
    /// Edges of the panel's axes on the page [inch]: distances from the left edge of the page
    /// (`left`, `right`) and from the lower edge of the page (`bottom`, `top`).
    double left = 0, right = 0, bottom = 0, top = 0;
    AxisRange x, y;
    bool log_x = false, log_y = false;

    /// Returns the point on the page [inch] at which the figure shows a data point.
    /// @param value_x value of the data point on the x axis, in the unit of the axis
    /// @param value_y value of the data point on the y axis, in the unit of the axis
    PaperPoint at(double value_x, double value_y) const;
};

/// Height of one line of the names that an x axis shows in place of numbers [inch].
constexpr double name_line = 0.19;

/// Layout of the page of a figure, in inches. The program computes the layout before gnuplot draws
/// the figure. Symbols and key can therefore be placed in inches and keep their shape.
struct Page {
    /// Width and height of the figure's page [inch].
    double width = 0, height = 0;
    /// Title of the figure. Line ends divide a title that would be wider than the page.
    std::string title;
    std::vector<PanelPlace> panels;
};
/// Returns the layout of a figure's page: the size of the page, the title with line ends, and the
/// place of each panel.
Page page_of(const Figure& figure);

}  // namespace pendular
