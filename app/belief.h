#pragma once

#include <string>

#include "analysis/misfit/believable.h"
#include "app/console.h"

namespace pendular::app {

/// Returns the end of a sentence on a fitted value, after "; ". Without a reason against the fit,
/// it is `basis`. Otherwise it is "do not use this value" with the most serious reason in `belief`.
/// @param basis text that says where the standard error of the value comes from
/// @param what text in place of "this value"
std::string verdict_on(const Belief& belief, const std::string& basis,
                       const std::string& what = "this value");

/// Prints the reasons not to believe a fit, one per line.
/// @param named_already number of reasons, counted from the first, to leave out, since the command
///        has printed them before
/// @param heading text before each reason
void print_doubts(Console& console, const Belief& belief, std::size_t named_already = 0,
                  const std::string& heading = "Doubt: ");

}  // namespace pendular::app
