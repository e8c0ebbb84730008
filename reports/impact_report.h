#pragma once

#include <string>
#include <vector>

#include "analysis/diagnosis/impact.h"

namespace pendular {

/// Sentences, at most two, on the shift of the friction by the effects or measurements that a
/// verdict names, at their estimated sizes. If the verdict names none that would shift the
/// friction, the sentences are on the effects with the largest shifts at the smallest sizes that
/// matter: "If wall-friction of 0.05 were present, the fitted friction would be 0.012 lower.".
/// Shifts below a tenth of the friction's standard error are left out. Empty where no known effect
/// explains the readings.
std::vector<std::string> impact_lines(const ImpactTable& table, const Diagnosis& diagnosis);

/// Name of an effect, or of an error of measurement with the quantity that is in error: "shear
/// stress, the readings of dry_1.csv".
std::string impact_name(const Impact& impact);

/// Table of the shift of the friction by each effect and each error of measurement, with a heading,
/// one row for each and one row for each group, and lines that explain the columns.
std::vector<std::string> impact_table(const ImpactTable& table);

}  // namespace pendular
