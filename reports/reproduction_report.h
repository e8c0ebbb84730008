#pragma once

#include <string>
#include <vector>

#include "workflow/reproduction.h"

namespace pendular {

/// Sentence on how many numbers of Badetti et al. (2018) the simulations reproduce, and from which
/// simulations.
std::string verdict_of(const Reproduction& reproduction);

/// Table of published and simulated numbers, one line for each row of the scoreboard; rows that
/// agree are left out unless `all` is true.
std::vector<std::string> scoreboard_table(const std::vector<ScoreboardRow>& rows, bool all);

/// Table of the observables of structure at two stiffness numbers, one line for each state that was
/// simulated at both; empty where there is none.
std::vector<std::string> stiffness_table(const PaperStudy& study);

/// Page in Markdown on the reproduction of Badetti et al. (2018): the scoreboard by section, the
/// comparison of stiffness numbers, and how to repeat it.
std::string reproduction_page(const Reproduction& reproduction);

}  // namespace pendular
