#pragma once

#include <vector>

#include "calib/fit/calibration.h"
#include "calib/fit/study_model.h"
#include "reports/figure.h"

namespace pendular {

/// Returns figures of a fit's parameters: `profile`, the profile likelihood of each parameter
/// beside the parabola of its standard error, and `corner`, the confidence region of each pair of
/// parameters. A parameter that the readings do not determine is left out. `corner` needs two
/// parameters.
std::vector<Figure> parameter_figures(const StudyModel& model, const Calibration& calibration);

}  // namespace pendular
