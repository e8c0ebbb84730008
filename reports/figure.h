#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "reports/symbol.h"

namespace pendular {

/// One series of data in a panel (pair of axes) of a figure: points, line, band or bars. A curve
/// without data only adds an entry to the key.
struct Curve {
    /// Way in which the data are drawn. `bars` are vertical and stand on the x axis, or at `from`.
    /// `bars_across` are horizontal and begin at x = 0. `cells` are squares of side 1 in the units
    /// of the axes; `shade` gives the strength of their colour.
    enum class Style { points, line, dotted_line, dashed_line, band, bars, bars_across, cells };
    std::string label;
    Style style = Style::points;
    std::vector<double> x, y;
    /// Standard errors of the values y of the curve, drawn as error bars or as the half-width of a
    /// band.
    std::vector<double> y_error;
    /// Texts that are written at the points of the curve: above `bars`, in `cells`, or beside those
    /// `bars_across` that end beyond the axis.
    std::vector<std::string> names = {};
    /// Value y at which each bar of the curve begins; empty: the bars begin at the x axis.
    std::vector<double> from = {};
    /// Strength of the colour of each cell of the curve, from 0 to 1.
    std::vector<double> shade = {};
    std::string colour = "#000000";
    Symbol symbol = {};
    /// Factor on the usual width of the curve's line [1].
    double weight = 1;
    /// Factor on the usual area of the curve's symbols [1].
    double area = 1;
    /// Whether the key (legend) of the panel has an entry for the curve.
    bool in_key = true;
    /// Whether the CSV file of the figure contains the numbers of the curve.
    bool in_table = true;
};

/// Straight line across a panel of a figure at one value, with a band of its standard error:
/// horizontal at y = `value`, or vertical at x = `value`.
struct Reference {
    std::string label;
    double value = 0;
    double error = 0;
    bool vertical = false;
    std::string colour = "#888888";
};

/// Position of the key (legend) of a panel: in a corner of the axes, or to their right.
enum class Key { none, top_left, top_right, bottom_left, bottom_right, outside };

/// One pair of axes with the data drawn in it.
struct Panel {
    /// Labels of the x axis and of the y axis of the panel, with units.
    std::string x_label, y_label;
    bool log_x = false, log_y = false;
    std::vector<Reference> references;  ///< reference lines, drawn behind the curves
    std::vector<Curve> curves;
    /// Whether the panel has the line y = x and equal ranges of both axes.
    bool diagonal = false;
    /// Whether the panel has the line y = 0.
    bool zero_line = false;
    Key key = Key::none;
    /// Share of the panel's height that is kept free above the data, for the key [1].
    double headroom = 0;
    std::optional<std::pair<double, double>> x_range = {};
    /// Names that are shown below x = 1, 2, ... in place of numbers; each name is a list of lines
    /// of text.
    std::vector<std::vector<std::string>> x_names = {};
    /// Names that are shown to the left of y = 1, 2, ... in place of numbers. Empty names leave the
    /// axis without names, for a panel beside one that has them.
    std::vector<std::string> y_names = {};
    /// Whether the y axis of the panel includes zero, unless the axis is logarithmic.
    bool y_from_zero = false;
    /// Least extent of the y axis to both sides of zero, in the unit of the axis; 0: no limit.
    double y_least = 0;
    /// Least and greatest value on the y axis, without the headroom; empty: chosen from the data.
    std::optional<std::pair<double, double>> y_range = {};
};

/// Figure of a report: panels (pairs of axes) under one title, side by side or stacked.
struct Figure {
    /// Name of the figure's files, without extension.
    std::string name;
    std::string title;
    std::vector<Panel> panels;
    /// Whether the panels of the figure stand one above the other instead of side by side.
    bool stacked = false;
    /// Number of panels in a row of the figure; 0: all panels are in one row.
    std::size_t columns = 0;
    /// Whether the panels of the figure are small, for figures with many panels.
    bool small = false;
};

}  // namespace pendular
