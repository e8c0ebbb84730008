#pragma once

#include "analysis/misfit/believable.h"
#include "calib/fit/study_model.h"

namespace pendular {

/// Judges whether a calibration of a study can be believed, and returns the reasons against the
/// calibration. Reasons are a misfit larger than the errors allow, a fitted parameter at the end of
/// its range, implausible readings, and a column that was probably read in a wrong unit.
/// @param comparison comparison of the readings with the predictions of the calibration `c`
Belief belief_in(const ResolvedStudy& study, const Measurements& measurements, const Calibration& c,
                 const Comparison& comparison);

}  // namespace pendular
