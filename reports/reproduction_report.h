#pragma once

#include <string>
#include <vector>

#include "workflow/reproduction.h"

namespace pendular {

/// Sentence that says how many numbers of Badetti et al. (2018) the simulations reproduce, and from
/// which simulations.
std::string verdict_of(const Reproduction& reproduction);

/// Table of published and simulated numbers, one line below a heading for each number: what it is,
/// its published and simulated value, and whether they agree.
/// @param all whether numbers that agree are shown too
std::vector<std::string> scoreboard_table(const std::vector<ScoreboardRow>& rows, bool all);

/// Returns a page in Markdown on the reproduction of Badetti et al. (2018): tables of published and
/// simulated numbers, one for each section of the paper, and how to repeat the comparison.
std::string reproduction_page(const Reproduction& reproduction);

}  // namespace pendular
