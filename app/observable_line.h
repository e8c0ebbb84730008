#pragma once

#include <string>

#include "sim/dem/run.h"

namespace pendular::app {

/// Returns a line of text on a simulated or predicted observable: the name, the value with the
/// standard error, and the meaning of the observable.
std::string observable_line(dem::Observable which, const Mean& mean);

}  // namespace pendular::app
