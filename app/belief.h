#pragma once

#include <string>

#include "analysis/misfit/believable.h"
#include "app/console.h"

namespace pendular::app {

/// End of the sentence that states a fitted value: the basis of its error where the fit can be
/// believed, else the most serious reason not to use the value.
std::string verdict_on(const Belief& belief, const std::string& basis);

/// Prints the reasons not to believe a fit, one per line after `heading`. Leaves out the first
/// `named_already` reasons, which the answer has named.
void print_doubts(Console& console, const Belief& belief, std::size_t named_already = 0,
                  const std::string& heading = "Doubt: ");

}  // namespace pendular::app
