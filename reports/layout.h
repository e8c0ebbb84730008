#pragma once

#include <string>
#include <utility>
#include <vector>

#include "reports/figure.h"
#include "reports/ink.h"
#include "reports/key.h"
#include "reports/pens.h"

namespace pendular {

/// Least and greatest value on an axis, in its unit.
using AxisRange = std::pair<double, double>;

/// Place of a panel's axes on the page, with the ranges of values along them.
struct PanelPlace {
    double left = 0, right = 0, bottom = 0, top = 0;  ///< edges of the axes on the page [inch]
    AxisRange x = {}, y = {};
    bool log_x = false, log_y = false;

    /// Returns the point on the page [inch] that shows the data point (value_x, value_y).
    PaperPoint at(double value_x, double value_y) const;
};

constexpr double name_line = 0.19;     ///< height of a line of names below an x axis [inch]
constexpr double heading_line = 0.19;  ///< height of the heading of a panel [inch]

/// Place of the key of a panel on the page.
struct KeyPlace {
    std::size_t panel = 0;
    PaperPoint corner;  ///< upper left corner [inch]
    KeyLayout layout;
};

/// Widths of pages [inch] that are printed in one column of a journal and over its whole width,
/// and their printed widths [mm]. Texts of 9 pt on the page then have 6 pt in print.
constexpr double column_page = 5.0, wide_page = 10.4, column_in_print = 85, whole_in_print = 178;

/// Layout of a figure's page. It is computed before gnuplot draws, so that symbols and keys can be
/// placed in inches and keep their shape.
struct Page {
    double width = 0, height = 0;    ///< [inch]
    std::vector<std::string> title;  ///< lines, each no wider than the page
    std::vector<PanelPlace> panels;
    std::vector<KeyPlace> keys;

    /// Width in print [mm]: that of a column if the page is no wider than `column_page`.
    double printed_width() const;
};
Page page_of(const Figure& figure);

/// Returns what is drawn above axes and lines: title, error bars, symbols, bars, cells, names along
/// axes and keys.
/// @param page layout of this figure (`page_of`)
Ink marks_of(const Figure& figure, const Page& page);

}  // namespace pendular
