#pragma once

#include <string>

#include "analysis/misfit/believable.h"
#include "app/console.h"

namespace pendular::app {

/// Text that warns of a fit and states the most serious reason in `belief`: "Do not use the fitted
/// friction, 0.196 +- 0.005. The model does not describe ...". Empty where `belief` contains no
/// reason against the fit.
/// @param what what the user should not use, with its value
std::string warning_on(const Belief& belief, const std::string& what);

/// Prints the reasons not to believe a fit, one per line.
/// @param named_already number of reasons that the command has printed before; so many, from the
///        first on, are left out
/// @param heading text before each reason
void print_doubts(Console& console, const Belief& belief, std::size_t named_already = 0,
                  const std::string& heading = "Warning: ");

}  // namespace pendular::app
