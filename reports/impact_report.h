#pragma once

#include <string>
#include <vector>

#include "analysis/diagnosis/impact.h"

namespace pendular {

/// Returns at most two sentences on how much effects or errors of measurement shift the fitted
/// friction coefficient. The sentences concern the effects or errors that the verdict of the
/// diagnosis names, at their estimated sizes. With the verdicts nothing-missing and inconclusive,
/// the sentences state the largest shifts by effects at their smallest sizes of interest, as in
/// "With wall-friction in the model (coefficient = 0.05), the friction coefficient fitted to all
/// readings would be 0.1080 instead of 0.1200." Shifts below 0.3 standard errors of the friction
/// coefficient are left out. Returns an empty list if the verdict is unknown: no known effect
/// explains the misfit.
std::vector<std::string> impact_lines(const ImpactTable& table, const Diagnosis& diagnosis);

/// Returns names of effects in the order in which `table` lists the effects that a verdict names:
/// by the shift of the fitted friction coefficient at the smallest size of interest, the largest
/// first. Effects that `table` does not list come last, in the order of `effects`.
std::vector<std::string> by_impact(const ImpactTable& table,
                                   const std::vector<std::string>& effects);

/// Returns the name of an effect or of an error of measurement, for a row of a table or figure. An
/// error of measurement is named by the quantity in error and the readings concerned: "shear
/// stress, the readings of dry_1.csv".
std::string impact_name(const Impact& impact);

/// Returns a table that states by how much each effect and each error of measurement shifts the
/// fitted friction coefficient [1]. The first line is the heading. One row follows for each effect
/// or error that shifts the friction coefficient by at least 0.05 standard errors. One row states
/// the number of effects and errors with smaller shifts. One row follows for each group of effects
/// or errors, such as the instrument, with the root of the sum of squares of their shifts. The last
/// line explains the columns. The table is empty if `table` lists no effect or error.
std::vector<std::string> impact_table(const ImpactTable& table);

}  // namespace pendular
