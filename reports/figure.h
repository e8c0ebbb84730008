#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "reports/symbol.h"

namespace pendular {

/// Series of data in a panel. A curve without data only adds an entry to the key (legend).
struct Curve {
    /// `bars_across` are horizontal and begin at x = 0. `cells` are squares of side 1 in the units
    /// of the axes. A `scale` is a sample in the key that runs through `colours`.
    enum class Style { points, line, dotted_line, dashed_line, band, bars_across, cells, scale };
    std::string label;
    Style style = Style::points;
    std::vector<double> x, y;
    std::vector<double> y_error;  ///< standard errors of y: error bars, or half-width of a band
    std::vector<double> x_error = {};  ///< standard errors of x: horizontal error bars of points
    /// Texts at the points: above `points`, inside `cells`. `bars_across` draws a text only in a
    /// bar that the edge of the panel cuts off.
    std::vector<std::string> names = {};
    std::vector<double> shade = {};  ///< strength of each cell's colour, from 0 (invisible) to 1
    std::vector<std::string> colours = {};  ///< of a `scale`, from its first to its last value
    std::string colour = "#000000";
    Symbol symbol = {};
    std::string dash = {};  ///< of a line, in gnuplot's syntax; empty: that of `style`
    double weight = 1;      ///< width of the line over the usual width [1]
    /// Whether the sample of a line in the key has a band behind it, and the symbol on it.
    bool banded = false, marked = false;
    double area = 1;       ///< area of the symbols over the usual area [1]
    bool drawn = true;     ///< otherwise only the CSV file has the values
    bool in_key = true;    ///< whether the key has an entry
    bool in_table = true;  ///< whether the CSV file has the values
};

/// Straight line across a panel at `value`, with a band of half-width `error` (one standard error).
struct Reference {
    std::string label;
    double value = 0;
    double error = 0;
    bool vertical = false;
    std::string colour = "#888888";
};

/// Pair of axes with the data drawn in it.
struct Panel {
    std::string x_label, y_label;  ///< with units
    std::string heading = {};      ///< above the axes
    bool log_x = false, log_y = false;
    std::vector<Reference> references;  ///< reference lines, drawn behind the curves
    std::vector<Curve> curves;
    bool diagonal = false;   ///< line y = x and equal ranges of both axes
    bool zero_line = false;  ///< line y = 0, included in the y axis
    /// Whether the entries of the panel stand in a key: above its axes or, where no other panel of
    /// the figure has a key, below the title.
    bool key = false;
    std::optional<std::pair<double, double>> x_range = {};
    /// Names at x = 1, 2, ... in place of numbers, each a list of lines.
    std::vector<std::vector<std::string>> x_names = {};
    /// Tick labels at y = 1, 2, ... in place of numbers. Empty texts leave the axis without labels,
    /// for a panel to the right of one that shows them.
    std::vector<std::string> y_names = {};
    bool y_from_zero = false;  ///< whether y includes 0; a logarithmic axis never does
    double y_least = 0;        ///< the y axis includes +-y_least; 0: no such range
    std::optional<std::pair<double, double>> y_range = {};
    /// Whether x is an uncertain quantity as y is, so that points with an error of y have one of x.
    bool x_uncertain = false;
};

/// Panels under one title, in rows or stacked.
struct Figure {
    std::string name;  ///< of the files, without extension
    std::string title;
    std::vector<Panel> panels;
    bool stacked = false;     ///< panels one above the other instead of side by side
    std::size_t columns = 0;  ///< panels in a row; 0: all
};

// Texts of figures use the markup of gnuplot's enhanced text mode: "σ_{22}" has a subscript. Names,
// units and file names from a user must be escaped by `plain_text` or `broken_name` first.

/// Returns a text escaped for a figure, so that gnuplot shows it as the user wrote it. Control
/// characters, including line ends, become blanks.
std::string plain_text(const std::string& text);

/// Returns a text without the escapes of `plain_text`; markup such as "_{22}" stays.
std::string unescaped(const std::string& text);

/// Breaks a name into short, escaped lines for an x axis: "capillary-", "shear-", "stress". Lines
/// end at line ends, after a hyphen if the line would exceed 10 characters, and inside a word of
/// more than 24 characters.
std::vector<std::string> broken_name(const std::string& name);

/// Returns a gnuplot string in double quotes in which gnuplot neither executes a command nor
/// substitutes a variable: all but letters, blanks and characters beyond ASCII are octal codes.
std::string gnuplot_string(const std::string& text);

}  // namespace pendular
