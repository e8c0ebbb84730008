#pragma once

#include <string>
#include <vector>

#include "reports/figure.h"
#include "sim/catalogue/effect.h"

namespace pendular {

/// Returns a small picture of what happens in the cell with an effect, as SVG: the annular cell
/// with what the instrument shows, a table of readings, or two grains. The marked parts follow from
/// the effect's `change` alone, so that each effect of a user has a picture too: those members of
/// `CellState` that `show` changes, or those stages of `dem::ChangePairs` that are set.
///
/// Colours are variables of the page's style sheet, with those of a light page where there is none.
std::string cell_picture(const Effect& effect);

/// Returns what the picture shows, for readers who cannot see it.
std::string cell_picture_in_words(const Effect& effect);

/// Returns a small picture of how an effect changes stress ratio and solid fraction against the
/// reduced pressure, as SVG. Empty if the figure has no such curves.
/// @param signature from `signature_figure`
std::string change_picture(const Figure& signature);

}  // namespace pendular
