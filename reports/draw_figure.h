#pragma once

#include <filesystem>

#include "reports/figure.h"

namespace pendular {

/// Draws a figure with gnuplot as NAME.svg, NAME.png and NAME.pdf in `folder`, and writes the drawn
/// values to NAME.csv. NAME is the name of the figure. Creates a missing folder. Only one thread at
/// a time may call this function.
/// @throws std::runtime_error if gnuplot is missing, a drawing is incomplete or a file cannot be
///        written
void draw(const Figure& figure, const std::filesystem::path& folder);

}  // namespace pendular
