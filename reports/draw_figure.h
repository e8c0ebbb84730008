#pragma once

#include <filesystem>

#include "reports/figure.h"

namespace pendular {

/// Draws a figure by gnuplot as NAME.svg, NAME.png and NAME.pdf in `folder`, and writes the drawn
/// values as NAME.csv; NAME is the figure's `name`. Creates the folder where there is none.
/// To be called by one thread at a time.
/// @throws std::runtime_error where gnuplot is missing or a drawing is incomplete
void draw(const Figure& figure, const std::filesystem::path& folder);

}  // namespace pendular
