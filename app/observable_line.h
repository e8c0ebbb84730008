#pragma once

#include <string>

#include "sim/dem/run.h"

namespace pendular::app {

/// Line of text on an observable of a simulation: its name, its value with the standard error, and
/// its meaning.
std::string observable_line(dem::Observable which, const Mean& mean);

}  // namespace pendular::app
