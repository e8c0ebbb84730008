#pragma once

#include <string>
#include <vector>

#include "reports/figure.h"
#include "workflow/next.h"

namespace pendular {

/// Returns lines of text on the next readings to take. If several models fit the readings, the
/// lines list the measurements that tell these models apart, with the prediction of each model. If
/// no plan tells these models apart, the lines say so, and state the predictions for the
/// measurement for which the predictions differ most. If one model fits, the lines list the
/// standard errors of the model's parameters before and after the readings.
std::vector<std::string> plan_lines(const NextMeasurement& next);

/// Returns a figure of the predicted stress ratio and solid fraction against the normal stress,
/// with one curve and one band of one standard error for each model that fits the readings, for at
/// most five models. Liquid content, mass of beads, time, and inertial number or shear rate have
/// the values of the first suggested reading. Vertical lines mark the normal stresses of the
/// suggested readings that have these values. If no measurement is suggested, one line marks the
/// normal stress at which the predictions differ most. The figure has no panels if only one model
/// fits, or if all possible measurements are direct measurements of an effect's parameter.
Figure next_figure(const NextMeasurement& next);

}  // namespace pendular
