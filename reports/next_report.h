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

/// Figure of the stress ratio and solid fraction that each model that fits the readings predicts
/// against normal stress; vertical lines mark the readings to make. Without panels where one model
/// fits, or where parameters can be measured directly but no further reading can be made.
Figure next_figure(const NextMeasurement& next);

}  // namespace pendular
