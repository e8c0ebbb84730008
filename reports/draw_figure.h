#pragma once

#include <filesystem>

#include "reports/figure.h"

namespace pendular {

/// Draws a figure with gnuplot as NAME.svg, NAME.png and NAME.pdf in `folder`, and writes the drawn
/// values as NAME.csv, where NAME is the name of the figure. Creates the folder if the folder does
/// not exist. Only one thread at a time may call this function.
/// @throws std::runtime_error if gnuplot is missing, a drawing is incomplete or a file cannot be
///         written
void draw(const Figure& figure, const std::filesystem::path& folder);

}  // namespace pendular
