#pragma once

#include <string>
#include <vector>

#include "analysis/diagnosis/diagnosis.h"
#include "reports/figure.h"
#include "workflow/next.h"

namespace pendular {

/// Lines of text on the next measurement to make. Where several models fit the readings, the lines
/// list the measurements that tell these models apart, with the prediction of each model. Where one
/// model fits, they list the standard errors of its parameters before and after the measurement.
/// Where the diagnosis suspects errors in some readings, the first line says that these readings
/// should be repeated.
std::vector<std::string> next_lines(const NextMeasurement& next, const Diagnosis& diagnosis);

/// Joins lines on the next measurement to one paragraph, and leaves out indented lines, which
/// contain predictions and standard errors.
/// @param lines lines that `next_lines` returns
std::string next_paragraph(const std::vector<std::string>& lines);

/// Figure of predicted stress ratio and solid fraction against normal stress, one curve with its
/// band of one standard error for each model that fits the readings, at most five. All other
/// settings are those of the first suggested reading. Vertical lines mark the normal stresses of
/// the suggested readings. Without panels where only one model fits, and where the instrument can
/// only measure parameters directly.
Figure next_figure(const NextMeasurement& next);

}  // namespace pendular
