#pragma once

#include <string>
#include <vector>

#include "reports/figure.h"
#include "workflow/next.h"

namespace pendular {

/// One line about the measurement, then the prediction of each rival explanation for it, or the
/// errors of the parameters after it.
std::vector<std::string> next_lines(const NextMeasurement& next);

/// Figure of the rivals' predictions along the normal stress, through the point to measure.
Figure next_figure(const NextMeasurement& next);

}  // namespace pendular
