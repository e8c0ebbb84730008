#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "analysis/diagnosis/diagnosis.h"
#include "analysis/diagnosis/impact.h"
#include "data/annular_cell.h"
#include "sim/catalogue/effect_catalogue.h"
#include "workflow/study_diagnosis.h"

namespace pendular {

/// Returns what all decisions mean, as lines of a help text: the words, then the meaning.
std::string decisions_in_words();
/// Returns what a decision means: "the readings might not reveal the effect at that size".
std::string meaning_of(Decision decision);

/// Returns the test of an effect among the candidates of a diagnosis.
const Finding& finding_of(const Diagnosis& diagnosis, const ModelSpace& space,
                          const std::string& effect);

/// Returns the power [1] as text, such as "0.83"; "-" if the score test is significant (p < 0.05),
/// since power matters only for a test that found nothing.
std::string power_text(const Finding& finding);

/// Returns the estimate of the effect's first parameter with standard error and unit: from the
/// refit with this effect alone, which may not determine it ("0.5, not determined"), or, if none
/// converged, from the score test. For an effect that is on or off, the text is "switch".
std::string estimate_of(const Diagnosis& diagnosis, const Finding& finding,
                        const ModelSpace& space);

/// Returns chi2/dof [1] with the effect in the model: "1.40" from a refit, "~1.62" if predicted.
std::string remaining_chi2_text(const Diagnosis& diagnosis, const Finding& finding,
                                const ModelSpace& space);

/// Returns a table of the tested effects with fitted value, chi2/dof left and decision. The effects
/// of the verdict come first, then those with the largest reduction of chi2.
/// @param all whether to add the columns imitated share [%], power [1] and p value [1]
std::vector<std::string> diagnosis_table(const Diagnosis& diagnosis, const ModelSpace& space,
                                         bool all);

/// Returns a sentence for each named offset of torque or normal force that is too large to be one
/// of an instrument in service, beside the largest torque or force of the readings.
std::vector<std::string> implausible_offsets(const Diagnosis& diagnosis, const ModelSpace& space,
                                             const std::vector<Reading>& readings,
                                             const AnnularCell& cell);

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
