#pragma once

#include <string>

#include "analysis/believable.h"
#include "app/console.h"
#include "calib/study_model.h"

namespace pendular::app {

/// Judges a calibration, and, where its model is emulated, looks for a column in a wrong unit.
Belief belief_in(const Study& study, const Measurements& measurements, const Calibration& c,
                 const Comparison& comparison);

/// The end of a first line: whether its numbers can be believed, or else what the errors rest on.
std::string verdict_on(const Belief& belief, const std::string& basis);

/// One line for each reason, as a doubt.
void print_doubts(Console& console, const Belief& belief);

}  // namespace pendular::app
