#pragma once

#include <string>
#include <vector>

#include "analysis/misfit/believable.h"
#include "reports/output.h"
#include "workflow/fitted_study.h"

namespace pendular {

/// Returns a discrepancy as text: "0.4 % of the stress ratio and 0.06 % of the solid fraction".
std::string discrepancy_text(const std::array<double, 2>& discrepancy);

/// Returns a warning against the use of a fit, with the most serious reason in `belief`: "Do not
/// use the fitted intergranular friction coefficient, 0.196 +- 0.005. The model does not describe
/// ...". Empty if there is no reason against the fit.
/// @param what name and value of the fitted quantity, as in the example
std::string warning_on(const Belief& belief, const std::string& what);

/// Adds the reasons not to believe a fit, one per line, each after `heading`.
/// @param named_already number of reasons, from the first on, that the answer has stated
void add_doubts(Output& output, const Belief& belief, std::size_t named_already = 0,
                const std::string& heading = "Warning: ");

/// Adds notes on what limits a fit however well it describes the readings: readings that are
/// slower than all simulations, and a friction coefficient that is implausible for beads.
/// @param runs training runs of the emulator
void add_limits(Output& output, const std::vector<dem::RunResult>& runs,
                const std::vector<Reading>& readings, double friction);

/// Returns what `pendular calibrate` says of a fit: its parameters with their errors or, if it
/// cannot be believed, why; then the evidence.
/// @param study the study's name as the user gave it
/// @param all whether to show all tables
Output calibration_output(const FittedStudy& result, const Measurements& measurements,
                          const std::string& study, bool all);

/// Returns what `pendular compare` says of a fit and its misfit.
Output comparison_output(const FittedStudy& compared, const WhereItFails& where,
                         const Measurements& measurements, bool all);

}  // namespace pendular
