#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "reports/symbol.h"

namespace pendular {

/// Series of data in a panel (pair of axes) of a figure, drawn as points, line, band, bars or
/// cells. A curve without data only adds an entry to the key (legend).
struct Curve {
    /// Way in which the data of the curve are drawn. `bars` are vertical and begin at the values
    /// `from` or, without these values, at the x axis. `bars_across` are horizontal and begin at
    /// x = 0. `cells` are squares whose side is 1 in the units of the axes, and `shade` gives the
    /// strength of their colour.
    enum class Style { points, line, dotted_line, dashed_line, band, bars, bars_across, cells };
    std::string label;
    Style style = Style::points;
    std::vector<double> x, y;
    /// Standard errors of the values y of the curve, in the unit of the y axis. Standard errors are
    /// drawn as error bars or as the half-width of a band.
    std::vector<double> y_error;
    /// Texts at the points of the curve. The style `bars` draws a text at the end of each bar, and
    /// `cells` draws a text inside each cell. `bars_across` draws a text only in a bar that the
    /// edge of the panel cuts off, inside the end of the bar.
    std::vector<std::string> names = {};
    /// Values y at which the bars of the curve begin, one for each bar, in the unit of the y axis.
    /// If the list is empty, the bars begin at the x axis.
    std::vector<double> from = {};
    /// Strength of the colour of each cell of the curve, from 0 (invisible) to 1 (strongest).
    std::vector<double> shade = {};
    std::string colour = "#000000";
    Symbol symbol = {};
    /// Width of the curve's line divided by the usual width [1].
    double weight = 1;
    /// Area of the curve's symbols divided by the usual area [1].
    double area = 1;
    /// Whether the key (legend) of the panel has an entry for the curve.
    bool in_key = true;
    /// Whether the CSV file of the figure contains the values of the curve.
    bool in_table = true;
};

/// Straight line across a panel of a figure: horizontal at y = `value` or, if `vertical` is true,
/// vertical at x = `value`. A band of the half-width `error` (standard error of `value`) surrounds
/// the line.
struct Reference {
    std::string label;
    double value = 0;
    double error = 0;
    bool vertical = false;
    std::string colour = "#888888";
};

/// Position of the key (legend) of a panel: in a corner of the axes, or to the right of the axes.
enum class Key { none, top_left, top_right, bottom_left, bottom_right, outside };

/// Pair of axes of a figure with the data drawn in these axes.
struct Panel {
    /// Labels of the x axis and of the y axis of the panel, with units.
    std::string x_label, y_label;
    bool log_x = false, log_y = false;
    std::vector<Reference> references;  ///< reference lines, drawn behind the curves
    std::vector<Curve> curves;
    /// Whether the panel has the line y = x and equal ranges of both axes.
    bool diagonal = false;
    /// Whether the panel has the line y = 0. The y axis then includes zero.
    bool zero_line = false;
    Key key = Key::none;
    /// Share of the height of the panel's axes that is kept free above the data, for the key
    /// (legend) [1].
    double headroom = 0;
    std::optional<std::pair<double, double>> x_range = {};
    /// Names below the x axis at x = 1, 2, ... in place of numbers. Each name is a list of lines of
    /// text.
    std::vector<std::vector<std::string>> x_names = {};
    /// Tick labels of the y axis at y = 1, 2, ... in place of numbers. If the list is empty, the
    /// axis shows numbers. Empty texts leave the axis without labels, for a panel to the right of a
    /// panel that shows the labels.
    std::vector<std::string> y_names = {};
    /// Whether the y axis of the panel includes zero. A logarithmic axis never includes zero.
    bool y_from_zero = false;
    /// Half-width of a range that the y axis always includes: the axis extends at least from
    /// -`y_least` to `y_least`, in the unit of the axis; 0: no such range.
    double y_least = 0;
    /// Least and greatest value on the y axis, without the headroom, in the unit of the axis. If
    /// empty, the range follows from the data.
    std::optional<std::pair<double, double>> y_range = {};
};

/// Figure of a report: panels (pairs of axes) under one title, in rows or stacked.
struct Figure {
    /// Name of the figure's files, without extension.
    std::string name;
    std::string title;
    std::vector<Panel> panels;
    /// Whether the panels of the figure are stacked one above the other instead of side by side.
    bool stacked = false;
    /// Number of panels in a row of the figure; 0: all panels are in one row.
    std::size_t columns = 0;
    /// Whether the panels are drawn small, for figures with many panels.
    bool small = false;
};

}  // namespace pendular
