#pragma once

#include <string>

#include "analysis/misfit/believable.h"
#include "app/console.h"

namespace pendular::app {

/// Sentences that warn of a fit, "Do not use the fitted friction, 0.196 +- 0.005. The model does
/// not describe ...", with the most serious reason in `belief`; empty where it has no reason
/// against the fit. `what`: what not to use, with its value.
std::string warning_on(const Belief& belief, const std::string& what);

/// Prints the reasons in `belief` not to believe a fit, one per line, each after the text
/// `heading`. Leaves out the first `named_already` reasons, which the command has printed before.
void print_doubts(Console& console, const Belief& belief, std::size_t named_already = 0,
                  const std::string& heading = "Warning: ");

}  // namespace pendular::app
