#pragma once

#include <string>
#include <vector>

#include "analysis/diagnosis/impact.h"

namespace pendular {

/// Returns `effects`, sorted by the shift that each effect causes in the fitted friction
/// coefficient at its smallest size of interest, the largest shift first. Effects that `table` does
/// not list come last, in the order of `effects`.
/// @param effects names of effects that the verdict of a diagnosis names
std::vector<std::string> by_impact(const ImpactTable& table,
                                   const std::vector<std::string>& effects);

/// Returns the name of an effect or of an error of measurement, for a row of a table or figure. An
/// error of measurement is named by the quantity in error and the readings concerned: "shear
/// stress, the readings of dry_1.csv".
std::string impact_name(const Impact& impact);

/// Returns a table of the shifts of the fitted friction coefficient [1] by effects and by errors of
/// measurement. The table is empty if `table` lists no effect or error. The lines below the heading
/// are:
/// - one row for each effect or error that shifts the friction coefficient by at least 0.05
///   standard errors
/// - one row with the number of effects and errors with smaller shifts
/// - one row for each group of effects or errors, such as the instrument, with the root of the sum
///   of squares of their shifts
/// - an explanation of the columns
std::vector<std::string> impact_table(const ImpactTable& table);

}  // namespace pendular
