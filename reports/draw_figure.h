#pragma once

#include <filesystem>

#include "reports/figure.h"

namespace pendular {

/// Draws the figure through gnuplot as NAME.svg, .png and .pdf, and writes its numbers as NAME.csv.
/// @throws std::runtime_error where gnuplot is missing or draws nothing
void draw(const Figure& figure, const std::filesystem::path& folder);

}  // namespace pendular
