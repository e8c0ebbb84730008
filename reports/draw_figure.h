#pragma once

#include <filesystem>

#include "reports/figure.h"

namespace pendular {

/// Draws a figure with gnuplot as NAME.svg, NAME.png and NAME.pdf in `folder`, and writes the drawn
/// values to NAME.csv. NAME is the name of the figure. Creates a missing folder. Only one thread at
/// a time may call this function. Values that are not finite are not drawn, nor is a panel without
/// an extent: one whose axes have no range to show. A figure without such panels is not drawn.
/// @return whether the figure was drawn
/// @throws std::runtime_error if gnuplot is missing, a drawing is incomplete or a file cannot be
///        written
bool draw(const Figure& figure, const std::filesystem::path& folder);

}  // namespace pendular
