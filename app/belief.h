#pragma once

#include <string>

#include "analysis/misfit/believable.h"
#include "app/console.h"

namespace pendular::app {

/// End of an answer: the basis of the errors, or the reason not to use the value.
std::string verdict_on(const Belief& belief, const std::string& basis);

/// Prints each reason for doubt on its own line, except the first `named_already`.
void print_doubts(Console& console, const Belief& belief, std::size_t named_already = 0,
                  const std::string& heading = "Doubt: ");

}  // namespace pendular::app
