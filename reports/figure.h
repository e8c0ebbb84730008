#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pendular {

/// One set of data in a panel.
struct Curve {
    enum class Style { points, line, band };
    std::string label;  ///< empty: not in the key
    Style style = Style::points;
    std::vector<double> x, y;
    std::vector<double> y_error;  ///< of points: bars; of a band: its half-width
    std::string colour = "#000000";
    int symbol = 7;  ///< gnuplot point type
};

/// A value with its error that runs across a panel: horizontal, or vertical at one x.
struct Reference {
    std::string label;
    double value = 0;
    double error = 0;
    bool vertical = false;
    std::string colour = "#888888";
};

/// One pair of axes.
struct Panel {
    std::string x_label, y_label;  ///< with units
    bool log_x = false;
    std::vector<Reference> references;  ///< drawn first
    std::vector<Curve> curves;
    bool diagonal = false;  ///< y = x, for parity
    bool zero_line = false;
    std::string key;      ///< where the key stands, in gnuplot's words; empty: none
    double headroom = 0;  ///< share of the height kept free above the data, for the key
    std::optional<std::pair<double, double>> x_range = {};
    double y_least = 0;  ///< the y axis reaches at least this far to both sides of zero
};

/// Panels side by side or above one another, under one title.
struct Figure {
    std::string name;  ///< file name without extension
    std::string title;
    std::vector<Panel> panels;
    bool stacked = false;  ///< above one another
};

/// Draws the figure through gnuplot as NAME.svg, .png and .pdf, and writes its numbers as NAME.csv.
/// @throws std::runtime_error where gnuplot is missing or draws nothing
void draw(const Figure& figure, const std::filesystem::path& folder);

}  // namespace pendular
