#pragma once

#include <string>
#include <vector>

#include "analysis/diagnosis/impact.h"

namespace pendular {

/// At most two sentences on how much the effects or measurements that a verdict names shift the
/// friction at their estimated sizes. If the verdict names no effect or measurement that would
/// shift the friction, the sentences state the largest shifts by effects of their smallest sizes of
/// interest: "If wall-friction of 0.05 were present, the fitted friction would be 0.012 lower."
/// Shifts below a tenth of the friction's standard error are left out. Empty where no known effect
/// explains the readings.
std::vector<std::string> impact_lines(const ImpactTable& table, const Diagnosis& diagnosis);

/// Name of an effect; for an error of measurement, the quantity in error and the readings: "shear
/// stress, the readings of dry_1.csv".
std::string impact_name(const Impact& impact);

/// Table that states how much each effect and each error of measurement shifts the fitted friction
/// [1]. It has a heading, one row for each effect or error, one row for each group of effects or
/// errors, and lines that explain the columns.
std::vector<std::string> impact_table(const ImpactTable& table);

}  // namespace pendular
