#pragma once

#include <string>
#include <vector>

#include "analysis/diagnosis/diagnosis.h"
#include "analysis/misfit/checks.h"

namespace pendular {

/// The verdict in one line, in plain words: "Missing: torque-offset (0.41 +- 0.03 mN m). Adding it
/// should cut chi2/dof from 9.8 to 1.1.", "Something is missing that no known effect explains; it
/// grows with height."
std::string verdict_line(const Diagnosis& diagnosis, const ModelSpace& space, const Checks& checks);

/// What was tested and what came of it, one line a candidate, most telling first; then the suspects
/// that stand out.
std::vector<std::string> diagnosis_table(const Diagnosis& diagnosis, const ModelSpace& space,
                                         const Evidence& evidence);

/// What to do next; `study` as the user names it.
std::vector<std::string> advice_on(const Diagnosis& diagnosis, const ModelSpace& space,
                                   const std::string& study);

}  // namespace pendular
