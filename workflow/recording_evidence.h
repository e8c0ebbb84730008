#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "data/recordings/findings/finding.h"
#include "workflow/study_diagnosis.h"

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
std::vector<RecordingEvidence> recording_evidence(const StudyDiagnosis& diagnosis,
                                                  const std::vector<RecordingFinding>& findings);

/// Returns a text for the user, "The recordings themselves show: ...", with up to two sentences on
/// faults of the recordings and the number of sentences left out. If the first fault explains most
/// of the misfit, the text states the share of the misfit that this fault explains. Empty if
/// `evidence` is empty.
std::string recordings_line(const std::vector<RecordingEvidence>& evidence);

/// Returns a JSON array of faults found inside recordings, with one object for each fault. Each
/// object contains the share of the misfit that the fault explains [1], or null if the share was
/// not computed.
nlohmann::ordered_json to_json(const std::vector<RecordingEvidence>& evidence);

}  // namespace pendular
