#pragma once

#include <string>
#include <vector>

#include "sim/catalogue/effect_catalogue.h"
#include "workflow/study_diagnosis.h"

namespace pendular {

/// Returns the rank correlation gamma [1] between the liquid contents and the times of the wet
/// readings: 1 if the content never decreases with time, -1 if it never increases. Pairs with equal
/// contents or times do not count; 0 if no pair counts.
/// Source: Goodman and Kruskal, J. Am. Stat. Assoc. 49 (1954) 732.
double order_of_contents(const std::vector<Reading>& readings);

/// Returns a warning that the diagnosis may have mistaken a dependence on the liquid content for a
/// change with time. Empty unless the diagnosis names an effect that changes with time, and
/// `order_of_contents` is at least 0.9 or at most -0.9.
std::string order_line(const StudyDiagnosis& diagnosis, const EffectCatalogue& catalogue);

/// Returns a text for the user on rival models: their effects, their chi2 [1], and how the effects
/// can be measured directly. Empty if there are none.
/// @param chi2 chi2 of the study's model [1]
std::string rivals_line(const std::vector<FittedModel>& rivals, double chi2,
                        const EffectCatalogue& catalogue);

/// Returns a text on how each effect can be measured directly, such as "contact-angle by ...;
/// torque-gain by ...". Effects without a direct measurement are left out.
std::string direct_methods(const std::vector<std::string>& effects,
                           const EffectCatalogue& catalogue);

}  // namespace pendular
