#pragma once

#include <string>
#include <vector>

#include "reports/figure.h"
#include "workflow/next.h"

namespace pendular {

/// Lines of text on the next measurement to make. Where several models fit the readings, they list
/// the measurements that tell these models apart, with the prediction of each model. Where one
/// model fits, they list the standard errors of its parameters before and after the measurement.
std::vector<std::string> next_lines(const NextMeasurement& next);

/// Paragraph on the next measurement to make: the lines of `next_lines` without the predictions and
/// errors that are indented below them.
std::string next_paragraph(const std::vector<std::string>& lines);

/// Figure of predicted stress ratio and solid fraction against normal stress, with one curve and
/// its band of one standard error for each model that fits the readings, at most five. All other
/// settings are those of the first reading to make. Vertical lines mark the normal stresses of the
/// readings to make. The figure has no panels where only one model fits, and where the rig can make
/// direct measurements of parameters only.
Figure next_figure(const NextMeasurement& next);

}  // namespace pendular
