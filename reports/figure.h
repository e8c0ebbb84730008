#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "reports/symbol.h"

namespace pendular {

/// One set of data in a panel. Without data it only adds an entry to the key.
struct Curve {
    enum class Style { points, line, dotted_line, dashed_line, band, bars };
    std::string label;
    Style style = Style::points;
    std::vector<double> x, y;
    std::vector<double> y_error;          ///< of points: bars; of a band: its half-width
    std::vector<std::string> names = {};  ///< above bars
    std::string colour = "#000000";
    Symbol symbol = {};
    double weight = 1;  ///< of a line, by which it is wider than usual
    double area = 1;    ///< of symbols, by which they are larger than usual
    bool in_key = true;
    bool in_table = true;  ///< its numbers are written too
};

/// A value with its error that runs across a panel: horizontal, or vertical at one x.
struct Reference {
    std::string label;
    double value = 0;
    double error = 0;
    bool vertical = false;
    std::string colour = "#888888";
};

/// Where a panel's key stands: in a corner, or to the right of the axes where none is free.
enum class Key { none, top_left, top_right, bottom_left, bottom_right, outside };

/// One pair of axes.
struct Panel {
    std::string x_label, y_label;  ///< with units
    bool log_x = false, log_y = false;
    std::vector<Reference> references;  ///< drawn first
    std::vector<Curve> curves;
    bool diagonal = false;  ///< y = x, for parity
    bool zero_line = false;
    Key key = Key::none;
    double headroom = 0;  ///< share of the height kept free above the data, for the key
    std::optional<std::pair<double, double>> x_range = {};
    /// Labels at x = 1, 2, ... in place of numbers, each as lines of text.
    std::vector<std::vector<std::string>> x_names = {};
    bool y_from_zero = false;  ///< where it is not logarithmic
    double y_least = 0;        ///< the y axis reaches at least this far to both sides of zero
    std::optional<std::pair<double, double>> y_range = {};  ///< before headroom
};

/// Panels side by side or above one another, under one title.
struct Figure {
    std::string name;  ///< file name without extension
    std::string title;
    std::vector<Panel> panels;
    bool stacked = false;     ///< above one another
    std::size_t columns = 0;  ///< after so many panels side by side a new row begins; 0: never
    bool small = false;       ///< panels side by side are small ones, where there are many
};

}  // namespace pendular
