#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "data/recordings/findings/finding.h"
#include "workflow/study_diagnosis.h"

namespace pendular {

/// Finding inside the recordings of a study, as evidence in a diagnosis.
struct RecordingEvidence {
    RecordingFinding finding;
    /// Share of the excess chi2 - dof of the model without further effects that a common factor on
    /// the readings concerned would remove, beyond what the calibrated parameters imitate [1];
    /// negative: not tested, since no reading concerned is left or the model has no excess.
    double explains = -1;
    /// Whether this factor reduces chi2 by more than each candidate effect would.
    bool beats_effects = false;

    /// Whether the finding alone explains most of the misfit, or more of it than any effect.
    bool explains_most() const { return explains >= 0.5 || (explains > 0 && beats_effects); }
};

/// Findings in the recordings of a diagnosed study that matter for its verdict, those that explain
/// most first: all saturations and steps between recordings, and other findings at readings whose
/// common factor would reduce chi2 significantly (p < 0.01).
std::vector<RecordingEvidence> recording_evidence(const StudyDiagnosis& diagnosis,
                                                  const std::vector<RecordingFinding>& findings);

/// Line "The recordings themselves show: ..." on up to two kinds of findings; empty for none.
std::string recordings_line(const std::vector<RecordingEvidence>& evidence);

/// JSON array with one object for each finding, as in the JSON of an import, and the share of the
/// misfit that it explains.
nlohmann::ordered_json to_json(const std::vector<RecordingEvidence>& evidence);

}  // namespace pendular
