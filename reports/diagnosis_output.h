#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/next_steps.h"
#include "reports/output.h"
#include "workflow/study_diagnosis.h"

namespace pendular {

/// Diagnosis of a study with all that a text on it needs.
struct DiagnosisParts {
    const StudyDiagnosis& diagnosis;
    const Checks& checks;                    ///< of the study's model without further effects
    const std::optional<Checks>& remaining;  ///< with the leading effects; empty without any
    const std::optional<ImpactTable>& impacts;
    const std::vector<NextStep>& steps;
    const ResolvedStudy& study;
    const Measurements& measurements;
    std::string name;  ///< the study's name as the user gave it
    bool all = false;  ///< whether to show all tables
};

/// Returns why a verdict is not firm; empty if it is.
std::string why_open(const Confirmation& confirmed);

/// Returns what `pendular diagnose` says: the verdict, doubts about it, the evidence, most
/// important first, and what to do next.
Output diagnosis_output(const DiagnosisParts& parts);

}  // namespace pendular
