#pragma once

#include "analysis/misfit/believable.h"
#include "calib/fit/study_model.h"

namespace pendular {

/// Judges whether a calibration can be believed, by its misfit, parameters at the end of their
/// range and doubts about readings, and looks for a column of the recordings that was read in a
/// wrong unit and would explain its misfit.
Belief belief_in(const ResolvedStudy& study, const Measurements& measurements, const Calibration& c,
                 const Comparison& comparison);

}  // namespace pendular
