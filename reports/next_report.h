#pragma once

#include <string>
#include <vector>

#include "reports/figure.h"
#include "workflow/next.h"

namespace pendular {

/// Text on the next measurement to make. Where several models fit, it lists the readings that
/// separate these models, with the prediction of each model. Where one model fits, it lists the
/// standard errors of its parameters before and after the measurement.
std::vector<std::string> next_lines(const NextMeasurement& next);

/// Figure of the predictions of the models that fit against normal stress, with the readings to
/// make. Without panels where one model fits or only direct measurements are possible.
Figure next_figure(const NextMeasurement& next);

}  // namespace pendular
