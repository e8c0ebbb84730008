#pragma once

#include <string>
#include <vector>

#include "analysis/diagnosis/impact.h"

namespace pendular {

/// Returns at most two sentences on how much effects or errors of measurement shift the fitted
/// friction coefficient. The sentences concern the effects or errors that the verdict of the
/// diagnosis names, at their estimated sizes. If the verdict is nothing-missing or inconclusive,
/// the sentences concern the first effects in `table`, at their smallest sizes of interest: "With
/// wall-friction in the model (coefficient = 0.05), the friction coefficient fitted to all readings
/// would be 0.1080 instead of 0.1200." Shifts below 0.3 standard errors of the friction coefficient
/// are left out. Returns an empty list if the verdict is unknown (no known effect explains the
/// misfit).
std::vector<std::string> impact_lines(const ImpactTable& table, const Diagnosis& diagnosis);

/// Returns names of effects from a verdict, sorted by the shift that each effect causes in the
/// fitted friction coefficient at its smallest size of interest, the largest shift first. Effects
/// that `table` does not list come last, in the order of `effects`.
/// @param effects names of effects that the verdict of the diagnosis names
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
