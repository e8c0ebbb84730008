#pragma once

#include <string>
#include <vector>

#include "workflow/reproduction.h"

namespace pendular {

/// Sentence on how many numbers of Badetti et al. (2018) the simulations reproduce, and from which
/// simulations.
std::string verdict_of(const Reproduction& reproduction);

/// Table of published and simulated numbers, one line for each row of the scoreboard.
/// @param all whether rows that agree are shown too
std::vector<std::string> scoreboard_table(const std::vector<ScoreboardRow>& rows, bool all);

/// Page in Markdown on the reproduction of Badetti et al. (2018): the scoreboard by section, and
/// how to repeat it.
std::string reproduction_page(const Reproduction& reproduction);

}  // namespace pendular
