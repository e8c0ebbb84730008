#pragma once

#include <string>
#include <vector>

#include "reports/figure.h"
#include "workflow/next.h"

namespace pendular {

/// Returns lines of text on the next readings to take:
/// - If one model fits the readings, the lines list the standard errors of its parameters before
///   and after the next readings.
/// - If several models fit, the lines list the measurements that tell the models apart, with the
///   prediction of each model.
/// - If several models fit and no possible series of readings tells the models apart, the lines say
///   so. The lines then state the predictions for the measurement for which the predictions differ
///   most.
std::vector<std::string> plan_lines(const NextMeasurement& next);

/// Returns a figure of the predicted stress ratio and solid fraction against the normal stress,
/// with a curve and a band of one standard error for each of up to five models that fit the
/// readings. All other quantities have the values of the first suggested reading or, without
/// suggested readings, of the reading for which the predictions differ most. Vertical lines mark
/// the normal stresses of the suggested readings. If no measurement is suggested, a line marks the
/// normal stress at which the predictions differ most. The figure has no panels if only one model
/// fits, or if all possible measurements are direct measurements of an effect's parameter.
Figure next_figure(const NextMeasurement& next);

}  // namespace pendular
