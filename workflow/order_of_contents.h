#pragma once

#include <string>

#include "sim/catalogue/effect_catalogue.h"
#include "workflow/study_diagnosis.h"

namespace pendular {

/// Returns the rank correlation [1] between the liquid contents of the wet readings and the times
/// at which the readings were taken: 1 if the content never decreases with time, -1 if the content
/// never increases. Pairs of readings with equal contents or equal times do not count. If there are
/// no other pairs, the result is 0.
/// Source: Goodman and Kruskal, J. Am. Stat. Assoc. 49 (1954) 732: gamma, a rank correlation.
double order_of_contents(const std::vector<Reading>& readings);

/// Returns a warning for the user that the diagnosis may have mistaken a dependence on the liquid
/// content for a change with time. The warning is given if the diagnosis names an effect that
/// changes with time, and if the liquid contents were measured in increasing or decreasing order.
/// The text is empty otherwise.
/// @param catalogue catalogue of effects, with the effects that the study defines
std::string order_line(const StudyDiagnosis& diagnosis, const EffectCatalogue& catalogue);

}  // namespace pendular
