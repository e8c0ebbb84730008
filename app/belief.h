#pragma once

#include <string>

#include "analysis/misfit/believable.h"
#include "app/console.h"

namespace pendular::app {

/// Text that ends a sentence on a fitted value, after "; ". If `belief` has no reason against the
/// fit, it is `basis`, which says where the value's standard error comes from; otherwise it is "do
/// not use this value" with the most serious reason. `what` names what not to use.
std::string verdict_on(const Belief& belief, const std::string& basis,
                       const std::string& what = "this value");

/// Prints the reasons in `belief` not to believe a fit, one per line, each after the text
/// `heading`. Leaves out the first `named_already` reasons, which the command has printed before.
void print_doubts(Console& console, const Belief& belief, std::size_t named_already = 0,
                  const std::string& heading = "Doubt: ");

}  // namespace pendular::app
