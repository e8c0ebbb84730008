#pragma once

#include "analysis/misfit/believable.h"
#include "calib/fit/study_model.h"

namespace pendular {

/// Judges a calibration, and, where its model is emulated, looks for a column in a wrong unit.
Belief belief_in(const ResolvedStudy& study, const Measurements& measurements, const Calibration& c,
                 const Comparison& comparison);

}  // namespace pendular
