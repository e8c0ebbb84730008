#pragma once

#include <vector>

#include "calib/fit/calibration.h"
#include "calib/fit/study_model.h"
#include "reports/figure.h"

namespace pendular {

/// Returns figures of the parameters that the readings determine:
/// - `profile`: profile likelihood of up to eight parameters, beside the parabola that follows from
///   the standard error
/// - `error_budget`: parts of the standard error of the first parameter, in a study that states
///   uncertainties of its instrument
/// - `corner`: confidence region of each pair of up to five parameters; left out for fewer than two
std::vector<Figure> parameter_figures(const StudyModel& model, const Calibration& calibration);

}  // namespace pendular
