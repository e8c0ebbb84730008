#pragma once

#include <string>
#include <vector>

#include "analysis/diagnosis/impact.h"
#include "reports/figure.h"

namespace pendular {

/// Returns `effects` in the order of `table`: the largest shift of the friction coefficient by the
/// smallest size of interest first. Effects that the table does not list come last.
/// @param effects names of effects that the verdict of a diagnosis names
std::vector<std::string> by_impact(const ImpactTable& table,
                                   const std::vector<std::string>& effects);

/// Returns the name for a row. An error of measurement is named by quantity and readings: "shear
/// stress, the readings of dry_1.csv".
std::string impact_name(const Impact& impact);

/// Returns a table of the shifts of the fitted friction coefficient [1]; empty if `table` is. It
/// has one row for each effect or error of measurement that shifts it by at least 0.05 standard
/// errors, the number of smaller ones, the root of the sum of squares of each group, such as the
/// instrument, and an explanation of the columns.
std::vector<std::string> impact_table(const ImpactTable& table);

/// Returns a figure of up to 16 effects and errors of measurement that shift the fitted friction
/// coefficient, the largest shift at the top. Without panels if none has an estimate with an error.
/// - Left: bars show the shift [10^-3] if the effect is one standard error larger or smaller than
///   estimated. A symbol shows the shift by the smallest size of interest, unless it would lie
///   outside the axes. The band is the standard error of the friction coefficient.
/// - Right: the pull [1], (estimate - value without the effect)/(standard error).
Figure impact_figure(const ImpactTable& table);

}  // namespace pendular
