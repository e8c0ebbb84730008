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
    /// Share of the excess chi2 - dof of the study's model that one common factor on the readings
    /// concerned would remove [1], beyond what a change of the calibrated parameters would.
    /// Negative: not computed, since none of these readings was tested or the diagnosis found no
    /// misfit.
    double explains = -1;
    /// Whether a common factor on the readings that the irregularity concerns reduces chi2 by more
    /// than each candidate effect would, and significantly (p < 0.01).
    bool beats_effects = false;

    /// Whether the irregularity explains at least half of the misfit, or more of it than any
    /// effect.
    bool explains_most() const { return explains >= 0.5 || (explains > 0 && beats_effects); }
};

/// Returns the irregularities inside a study's recordings that matter for its diagnosis, the one
/// that explains most of the misfit first. All saturations and steps between recordings are
/// included. Others are included if one common factor on the readings concerned would reduce chi2
/// significantly (p < 0.01).
/// @param findings all irregularities that the import found in the recordings
std::vector<RecordingEvidence> recording_evidence(const StudyDiagnosis& diagnosis,
                                                  const std::vector<RecordingFinding>& findings);

/// Text "The recordings themselves show: ..." with up to two sentences on irregularities of the
/// recordings; it adds how much of the misfit the first one explains if it explains most. Empty
/// where there are no irregularities.
std::string recordings_line(const std::vector<RecordingEvidence>& evidence);

/// JSON array of irregularities found inside recordings, one object for each, with the share of the
/// misfit that it explains [1]; null where this share was not computed.
nlohmann::ordered_json to_json(const std::vector<RecordingEvidence>& evidence);

}  // namespace pendular
