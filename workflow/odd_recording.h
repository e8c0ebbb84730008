#pragma once

#include <optional>

#include "analysis/misfit/odd_file.h"
#include "workflow/study_diagnosis.h"

namespace pendular {

/// Returns the model that explains the readings of a diagnosis best: the study's where it does, or
/// else the one with the effects that are missing.
const FittedModel& explaining_model(const Diagnosis& diagnosis);

/// Returns the file that deviates most from that model (`odd_file`); empty where the diagnosis
/// tests means over several files.
std::optional<OddFile> odd_recording(const StudyDiagnosis& diagnosis);

}  // namespace pendular
