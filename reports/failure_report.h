#pragma once

#include <string>
#include <utility>
#include <vector>

#include "analysis/diagnosis/recording_evidence.h"
#include "analysis/diagnosis/where_it_fails.h"

namespace pendular {

/// Returns a p value with two significant digits: "= 0.02", or "< 0.001" below 0.001.
/// @param equals text before a p value of 0.001 or more, such as "" in a column
std::string p_text(double p, const char* equals = "= ");

/// Returns the checks with p < 0.05, the smallest p first, as pointers into `checks`.
std::vector<const Check*> significant_checks(const Checks& checks);

/// Returns the combined p value of all checks, then a line for each check with p < 0.05. Checks of
/// correlation between neighbouring conditions share one line.
std::vector<std::string> checks_table(const Checks& checks);

/// Returns a sentence that names the three measurements with the smallest p values and counts the
/// others. Empty for none, and for more than eight, since the model then fails as a whole.
/// @param measurements names with p values [1]
std::string deviating_line(std::vector<std::pair<std::string, double>> measurements);

/// Returns the lines of `checks_table`, then the conditions and files that deviate most, if any.
std::vector<std::string> failure_table(const WhereItFails& where);

/// Returns "The recordings themselves show: ..." with up to two faults, the number of further
/// faults, and the share of the misfit that the first fault explains if it is most of it. Empty if
/// `evidence` is empty.
std::string recordings_line(const std::vector<RecordingEvidence>& evidence);

}  // namespace pendular
