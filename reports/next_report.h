#pragma once

#include <string>
#include <vector>

#include "reports/figure.h"
#include "workflow/next.h"

namespace pendular {

/// The measurement in one line, then what each rival says of it, or the parameters' errors after
/// it.
std::vector<std::string> next_lines(const NextMeasurement& next);

/// Figure of the rivals' predictions along the normal stress, through the point to measure.
Figure next_figure(const NextMeasurement& next);

}  // namespace pendular
