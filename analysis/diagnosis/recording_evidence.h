#pragma once

#include <vector>

#include "analysis/misfit/weighted_residuals.h"
#include "data/reading.h"

namespace pendular {

/// Fault found inside the recordings, such as a saturated sensor, and its part in the misfit.
struct RecordingEvidence {
    Remark finding;
    /// Share [1] of the misfit that the fault may explain, at most 1: reduction of chi2 by one
    /// fitted factor on the shear stresses (for a fault of the height: solid fractions) of the
    /// affected readings, as far as the calibrated parameters cannot imitate it, over chi2 - dof.
    /// Negative if no affected reading was tested or if there is no misfit.
    double explains = -1;
    /// Whether the factor would reduce chi2 significantly (p < 0.01) and by more than the score
    /// test predicts for any effect.
    bool beats_effects = false;

    /// Whether the fault explains at least half of the misfit, or more of it than any effect.
    bool explains_most() const { return explains >= 0.5 || (explains > 0 && beats_effects); }
};

/// Returns the faults that may explain the misfit, the one with the largest share first: all
/// saturated sensors and level changes between recordings, and other faults if the factor would
/// reduce chi2 significantly (p < 0.01).
/// @param excess chi2 - dof of the study's model [1]; 0 without a misfit
/// @param by_effects largest reduction of chi2 [1] that a score test predicts for an effect
std::vector<RecordingEvidence> recording_evidence(const std::vector<Remark>& findings,
                                                  const std::vector<Reading>& readings,
                                                  const WeightedResiduals& residuals, double excess,
                                                  double by_effects);

}  // namespace pendular
