#pragma once

#include <string>
#include <vector>

#include "analysis/diagnosis/diagnosis.h"
#include "reports/figure.h"
#include "workflow/next.h"

namespace pendular {

/// Whether the lines of `next_lines` ask the user to make measurements. False if several models fit
/// the readings and no plan can tell these models apart, or if the diagnosis found a misfit that no
/// known effect explains.
bool orders_readings(const NextMeasurement& next, const Diagnosis& diagnosis);

/// Returns lines of text on the next measurement to make. If several models fit the readings, the
/// lines list the measurements that tell these models apart, with the prediction of each model. If
/// no plan tells these models apart, the lines say so, and state the predictions for the
/// measurement for which the predictions differ most. If one model fits, the lines list the
/// standard errors of the model's parameters before and after the measurement. If the diagnosis
/// attributes the misfit to an error in some readings, the only line says that these readings
/// should be repeated. If no known effect explains the misfit, the only line says that no
/// measurement is planned.
std::vector<std::string> next_lines(const NextMeasurement& next, const Diagnosis& diagnosis);

/// Joins lines on the next measurement to one paragraph. Leaves out indented lines, which contain
/// predictions and standard errors.
/// @param lines lines that `next_lines` returns
std::string next_paragraph(const std::vector<std::string>& lines);

/// Returns a figure of the predicted stress ratio and solid fraction against the normal stress,
/// with one curve and one band of one standard error for each model that fits the readings, for at
/// most five models. Liquid content, mass of beads, time, and inertial number or shear rate have
/// the values of the first suggested reading. Vertical lines mark the normal stresses of the
/// suggested readings that have these values. If no measurement is suggested, one line marks the
/// normal stress at which the predictions differ most. The figure has no panels if only one model
/// fits, or if all possible measurements are direct measurements of an effect's parameter.
Figure next_figure(const NextMeasurement& next);

}  // namespace pendular
