#pragma once

#include <string>

#include "analysis/misfit/odd_file.h"
#include "workflow/study_diagnosis.h"

namespace pendular {

/// Returns sentences on the recording that deviates in another way than all others: how far, the
/// error of the gap that would do so, and how surely it does.
/// @param model what the readings were compared with, such as "the model with wall-friction"
std::string odd_file_text(const OddFile& odd, const std::string& model);

/// Returns the same on the readings of a diagnosis and the model that explains them best: the
/// study's or, where effects are missing, the one with these. Empty where no file is odd, or where
/// the readings are means over files.
std::string odd_file_line(const StudyDiagnosis& diagnosis);

/// Returns a sentence on the file that deviates most, odd or not. Empty where files cannot be
/// compared.
std::string files_line(const StudyDiagnosis& diagnosis);

}  // namespace pendular
