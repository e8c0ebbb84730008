#pragma once

#include <vector>

#include "analysis/reproduction/scoreboard.h"

namespace pendular {

/// Compares the simulations of the parameter study with each number that Badetti et al. (2018)
/// state of dry and wet grains. A published number without an error is taken to half a unit of its
/// last digit, a range to half a unit of the last digit of its more precise end, and a number of
/// one digit with the word "about" to 10 %; limits that the text states with a sign such as <= are
/// taken as they stand. Rows whose states no run simulates are left out.
std::vector<ScoreboardRow> compare_with_published(const PaperStudy& study);

}  // namespace pendular
