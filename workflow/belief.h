#pragma once

#include "analysis/misfit/believable.h"
#include "calib/fit/study_model.h"

namespace pendular {

/// Judges whether a calibration can be believed. Reasons against it are a misfit larger than the
/// errors allow, a fitted parameter at the end of its range, implausible readings, and a column
/// that was probably read in a wrong unit.
Belief belief_in(const ResolvedStudy& study, const Measurements& measurements, const Calibration& c,
                 const Comparison& comparison);

}  // namespace pendular
