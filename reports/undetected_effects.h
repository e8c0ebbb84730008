#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "analysis/diagnosis/impact.h"
#include "sim/catalogue/effect_catalogue.h"
#include "workflow/study_diagnosis.h"

namespace pendular {

inline constexpr std::size_t shown_undetected = 5;  ///< rows printed without --all

/// Returns a table of the effects of the smallest size of interest that could be present
/// undetected, the one that shifts the fitted friction coefficient most first. A line states this
/// shift, the smallest size of interest, the smallest size that these readings would show (for an
/// effect that is on or off: the percentage of repetitions that would detect it), and how to settle
/// whether the effect is there. Sizes are deviations of the parameter from the value without the
/// effect. Empty unless the verdict is inconclusive.
std::vector<std::string> undetected_table(const StudyDiagnosis& diagnosis,
                                          const std::optional<ImpactTable>& impacts,
                                          const EffectCatalogue& catalogue);

/// Returns a sentence that names the effects that the readings could not detect at any size within
/// the bounds of the parameter. Empty for none, or unless the verdict is inconclusive.
std::string undetectable_line(const Diagnosis& diagnosis, const ModelSpace& space);

}  // namespace pendular
