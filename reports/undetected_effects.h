#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "analysis/diagnosis/impact.h"
#include "sim/catalogue/effect_catalogue.h"
#include "workflow/study_diagnosis.h"

namespace pendular {

/// Largest number of rows of `undetected_table` (effects that could go undetected) that are printed
/// if the user does not give --all.
inline constexpr std::size_t shown_undetected = 5;

/// Returns a table of the effects that the study's readings cannot exclude: an effect of the
/// smallest size of interest could be present and remain undetected. Returns an empty list unless
/// the verdict of the diagnosis is inconclusive. One line follows the heading for each effect, the
/// effect that shifts the fitted friction coefficient most first. A line states:
/// - the shift of the friction coefficient by the effect at its smallest size of interest
/// - the smallest size of interest
/// - the smallest size that these readings would show or, for an effect that is on or off, the
///   percentage of repetitions of the study that would detect the effect
/// - how to settle whether the effect is there
///
/// Sizes are deviations of the effect's parameter from the value without the effect.
/// @param impacts shifts of the fitted friction coefficient by each effect
std::vector<std::string> undetected_table(const StudyDiagnosis& diagnosis,
                                          const std::optional<ImpactTable>& impacts,
                                          const EffectCatalogue& catalogue);

/// Returns a sentence that names the effects that the study's readings could not detect at any size
/// within the bounds of the effect's parameter. Returns an empty text if there is no such effect,
/// or unless the verdict of the diagnosis is inconclusive.
std::string undetectable_line(const Diagnosis& diagnosis, const ModelSpace& space);

}  // namespace pendular
