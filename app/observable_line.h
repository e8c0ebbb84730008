#pragma once

#include <string>

#include "sim/dem/run.h"

namespace pendular::app {

/// Returns a line with the name of an observable, its value with standard error, and its meaning.
std::string observable_line(dem::Observable which, const Mean& mean);

}  // namespace pendular::app
