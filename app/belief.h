#pragma once

#include <string>

#include "analysis/misfit/believable.h"
#include "app/console.h"

namespace pendular::app {

/// The end of a first line: whether its numbers can be believed, or else what the errors rest on.
std::string verdict_on(const Belief& belief, const std::string& basis);

/// One line for each reason, as a doubt.
void print_doubts(Console& console, const Belief& belief);

}  // namespace pendular::app
