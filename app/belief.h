#pragma once

#include <string>

#include "analysis/misfit/believable.h"
#include "app/console.h"

namespace pendular::app {

/// Sentences that warn of a fit, "Do not use the fitted friction, 0.196 +- 0.005. The model does
/// not describe ...", with the most serious reason in `belief`; empty where it has no reason
/// against the fit. `what`: what not to use, with its value.
std::string warning_on(const Belief& belief, const std::string& what);

/// Prints the reasons not to believe a fit, one per line.
/// @param named_already number of reasons, counted from the first, to leave out, since the command
///        has printed them before
/// @param heading text before each reason
void print_doubts(Console& console, const Belief& belief, std::size_t named_already = 0,
                  const std::string& heading = "Warning: ");

}  // namespace pendular::app
