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

}  // namespace pendular
