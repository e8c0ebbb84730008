#pragma once

#include <string>
#include <vector>

#include "workflow/reproduction.h"

namespace pendular {

/// Returns a sentence that says how many of the numbers published by Badetti et al. (2018) the
/// simulations reproduce, and how many simulated states were used.
std::string verdict_of(const Reproduction& reproduction);

/// Returns a table of numbers published by Badetti et al. (2018) and their simulated values, one
/// line per number below a heading. The line states the meaning of the number, the published and
/// the simulated value, and whether the two values agree.
/// @param all whether numbers that agree are shown too
std::vector<std::string> scoreboard_table(const std::vector<ScoreboardRow>& rows, bool all);

/// Returns a page in Markdown on the reproduction of Badetti et al. (2018). The page has a table of
/// published and simulated numbers for each section of the paper, and says how to repeat the
/// comparison.
std::string reproduction_page(const Reproduction& reproduction);

}  // namespace pendular
