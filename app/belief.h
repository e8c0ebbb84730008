#pragma once

#include <string>
#include <vector>

#include "analysis/misfit/believable.h"
#include "app/console.h"

namespace pendular::app {

/// Returns a warning against the use of a fit, with the most serious reason in `belief`: "Do not
/// use the fitted intergranular friction coefficient, 0.196 +- 0.005. The model does not describe
/// ...". Empty if there is no reason against the fit.
/// @param what name and value of the fitted quantity, as in the example
std::string warning_on(const Belief& belief, const std::string& what);

/// Prints the reasons not to believe a fit, one per line, each after `heading`.
/// @param named_already number of reasons, from the first on, that the command has printed before
void print_doubts(Console& console, const Belief& belief, std::size_t named_already = 0,
                  const std::string& heading = "Warning: ");

/// Prints notes on what limits a fit however well it describes the readings: readings that are
/// slower than all simulations, and a friction coefficient that is implausible for beads.
/// @param runs training runs of the emulator
void print_limits(Console& console, const std::vector<dem::RunResult>& runs,
                  const std::vector<Reading>& readings, double friction);

}  // namespace pendular::app
