#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "reports/figure.h"

namespace pendular {

/// Draws NAME.svg, NAME.png and NAME.pdf in `folder` with gnuplot and writes the drawn values to
/// NAME.csv; NAME is the figure's name. Creates a missing folder. One thread at a time only. Values
/// that are not finite are not drawn, nor are panels whose axes have no range to show.
/// @return whether the figure has a panel and was drawn
/// @throws std::runtime_error if gnuplot is missing, a drawing is incomplete or a file cannot be
///        written
bool draw(const Figure& figure, const std::filesystem::path& folder);

/// Draws figures in the same way, and returns the names of those that have a panel.
std::vector<std::string> draw_all(const std::vector<Figure>& figures,
                                  const std::filesystem::path& folder);

/// Returns the numbers of a figure as CSV (RFC 4180), one row per point and per reference line.
/// Columns: panel (from 1), curve (label), x, y, y_error (for a vertical reference line: of x),
/// x_name (in place of numbers), x_label, y_label; y_name, value (strength of a cell's colour) and
/// x_error (standard error of x) only in figures that have them. A name on the x axis without any
/// point has a row without y.
std::string numbers_table(const Figure& figure);

}  // namespace pendular
