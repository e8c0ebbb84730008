#pragma once

#include <string>
#include <vector>

#include "reports/output.h"
#include "workflow/reproduction.h"

namespace pendular {

/// Returns how many of the published numbers the simulations reproduce, and how many simulated
/// states were used.
std::string verdict_of(const Reproduction& reproduction);

/// Returns a table with the meaning of each published number, its published and simulated values,
/// and whether they agree.
/// @param all whether numbers that agree are shown too
std::vector<std::string> scoreboard_table(const std::vector<ScoreboardRow>& rows, bool all);

/// Returns a page in Markdown with a table of numbers for each section of Badetti et al. (2018),
/// and how to repeat the comparison.
std::string reproduction_page(const Reproduction& reproduction);

/// Returns what `pendular reproduce` says.
/// @param all whether numbers that agree are shown too
Output reproduction_output(const Reproduction& reproduction, bool all);

}  // namespace pendular
