#pragma once

#include <string>
#include <utility>
#include <vector>

#include "reports/figure.h"

namespace pendular {

/// Range of an axis.
using AxisRange = std::pair<double, double>;

/// Where one pair of axes lies on the page, and what it spans.
struct PanelPlace {
    double left = 0, right = 0, bottom = 0, top = 0;  ///< of the axes on the page [inch]
    AxisRange x, y;
    bool log_x = false, log_y = false;

    /// Where a value stands on the page [inch].
    PaperPoint at(double value_x, double value_y) const;
};

/// Height of a line of text along an axis [inch].
constexpr double name_line = 0.19;

/// A figure's page. Every place on it is known before it is drawn, so that symbols and key can be
/// drawn in inches and keep their shape.
struct Page {
    double width = 0, height = 0;  ///< [inch]
    std::string title;             ///< in as many lines as the width needs
    std::vector<PanelPlace> panels;
};
Page page_of(const Figure& figure);

}  // namespace pendular
