#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "data/recordings/findings/finding.h"
#include "workflow/study_diagnosis.h"

namespace pendular {

/// Irregularity found inside the recordings of a study, such as a saturated sensor, and the share
/// of the misfit that it may explain.
struct RecordingEvidence {
    /// The irregularity, as the import of the recordings found it.
    RecordingFinding finding;
    /// Share of the misfit that the irregularity may explain [1]: the reduction of chi2 if the
    /// affected readings were all multiplied by one fitted factor, divided by chi2 - dof of the
    /// study's model. What a change of the calibrated parameters can imitate does not count.
    /// Negative: not computed, since no affected reading was tested or the diagnosis found no
    /// misfit.
    double explains = -1;
    /// Whether multiplying the affected readings by one fitted factor would reduce chi2
    /// significantly (p < 0.01), and by more than any effect that the model may lack.
    bool beats_effects = false;

    /// Whether the irregularity explains at least half of the misfit, or more of the misfit than
    /// any physical effect.
    bool explains_most() const { return explains >= 0.5 || (explains > 0 && beats_effects); }
};

/// Returns the irregularities inside a study's recordings that may explain the misfit of its model,
/// the one with the largest share of the misfit first. Saturated sensors and steps between
/// recordings are always included. Other irregularities are included if multiplying the affected
/// readings by one fitted factor would reduce chi2 significantly (p < 0.01).
/// @param findings all irregularities that the import found in the recordings
std::vector<RecordingEvidence> recording_evidence(const StudyDiagnosis& diagnosis,
                                                  const std::vector<RecordingFinding>& findings);

/// Text "The recordings themselves show: ..." with up to two sentences on irregularities of the
/// recordings; if the first irregularity explains most of the misfit, a sentence adds its share.
/// Empty where `evidence` is empty.
std::string recordings_line(const std::vector<RecordingEvidence>& evidence);

/// JSON array of irregularities found inside recordings, one object for each, with the share of the
/// misfit that it explains [1]; null where this share was not computed.
nlohmann::ordered_json to_json(const std::vector<RecordingEvidence>& evidence);

}  // namespace pendular
