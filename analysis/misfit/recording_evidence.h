#pragma once

#include <vector>

#include "analysis/misfit/weighted_residuals.h"
#include "data/reading.h"
#include "data/recordings/findings/finding.h"

namespace pendular {

/// Fault found inside the recordings of a study, such as a saturated sensor, and the share of the
/// misfit that the fault may explain.
struct RecordingEvidence {
    /// Fault that the import found in the recordings.
    RecordingFinding finding;
    /// Share [1] of the misfit that the fault may explain, at most 1: reduction of chi2 by one
    /// fitted factor on all affected readings, divided by chi2 - dof of the study's model (dof:
    /// degrees of freedom). The factor multiplies shear stresses or, for a fault of the height,
    /// solid fractions. A change that the calibrated parameters can imitate does not count.
    /// Negative if no affected reading was tested, or if the diagnosis found no misfit.
    double explains = -1;
    /// Whether multiplying the affected readings by one fitted factor would reduce chi2
    /// significantly (p < 0.01), and by more than the score test (test without a refit) predicts
    /// for any effect that the model may lack.
    bool beats_effects = false;

    /// Whether the fault explains at least half of the misfit, or more of the misfit than any
    /// physical effect.
    bool explains_most() const { return explains >= 0.5 || (explains > 0 && beats_effects); }
};

/// Returns the faults inside a study's recordings that may explain the misfit of the study's model,
/// the fault with the largest share of the misfit first. Saturated sensors and level changes from
/// one recording to the next are always included. Any other fault is included if one fitted factor
/// on the affected readings would reduce chi2 significantly (p < 0.01).
/// @param findings all faults that the import found in the recordings
/// @param residuals residuals of `readings` from the study's model
/// @param excess chi2 - dof of the study's model [1]; 0 if there is no misfit to explain
/// @param by_effects largest reduction of chi2 [1] that a score test predicts for an effect
std::vector<RecordingEvidence> recording_evidence(const std::vector<RecordingFinding>& findings,
                                                  const std::vector<Reading>& readings,
                                                  const WeightedResiduals& residuals, double excess,
                                                  double by_effects);

}  // namespace pendular
