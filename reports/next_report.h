#pragma once

#include <string>
#include <vector>

#include "reports/figure.h"
#include "reports/next_steps.h"
#include "reports/output.h"
#include "workflow/next.h"

namespace pendular {

/// Returns lines on the next readings to take. If one model fits, they list the standard errors of
/// its parameters before and after these readings. If several fit, they list the measurements that
/// tell the models apart with the prediction of each model or, if no possible readings do, say so
/// and state the predictions where these differ most.
std::vector<std::string> plan_lines(const NextMeasurement& next);

/// Returns what `pendular next` says: what to do, in order, with the plan of the readings.
/// @param has_rig whether study.toml states the settings that the rheometer can reach
Output next_output(const NextMeasurement& next, const StudyDiagnosis& diagnosis,
                   const std::vector<NextStep>& steps, bool has_rig);

/// Returns a figure of the predicted stress ratio and solid fraction against the normal stress,
/// with a curve and a band of one standard error for each of up to five models that fit. All other
/// quantities are those of the first suggested reading or, without any, of the reading for which
/// the predictions differ most. Vertical lines mark the normal stresses of the suggested readings,
/// or the normal stress where the predictions differ most. Without panels if only one model fits,
/// or if all possible measurements are direct measurements.
Figure next_figure(const NextMeasurement& next);

}  // namespace pendular
