#pragma once

#include <vector>

#include "analysis/reproduction/scoreboard.h"

namespace pendular {

/// Compares simulations with each number that Badetti et al. (2018) state about dry and wet grains,
/// and returns a row for each number. A published number without an error is taken to be exact to
/// half a unit of its last digit. Most published ranges are taken to be exact to half a unit of the
/// last digit of the more precise end. The ranges of the reduced cohesion, of the growth of the
/// reduced cohesion, and of the ratio of capillary shear stresses are taken literally. A number of
/// one digit with the word "about" is taken to be exact to 10 %. Limits that the paper states with
/// a sign such as <= are taken literally. Rows whose states no run simulates are left out.
std::vector<ScoreboardRow> compare_with_published(const PaperStudy& study);

}  // namespace pendular
