#pragma once

#include <string>

#include "sim/dem/run.h"

namespace pendular::app {

/// Returns a line of text on an observable, a quantity that a simulation gives, such as the stress
/// ratio. The line has the name, the value with its standard error, and the meaning of the
/// observable.
/// @param mean simulated or predicted value with its standard error
std::string observable_line(dem::Observable which, const Mean& mean);

}  // namespace pendular::app
