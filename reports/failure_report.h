#pragma once

#include <string>
#include <utility>
#include <vector>

#include "analysis/diagnosis/where_it_fails.h"
#include "analysis/misfit/recording_evidence.h"

namespace pendular {

/// Returns the text of a p value [1] with two significant digits: "= 0.02", or "< 0.001" for a p
/// value below 0.001.
/// @param equals text before a p value of 0.001 or more, such as "" in a column of p values
std::string p_text(double p, const char* equals = "= ");

/// Returns the tests of a model's residuals that are each significant by themselves (p < 0.05), the
/// test with the smallest p first. Returns pointers to elements of `checks`.
std::vector<const Check*> significant_checks(const Checks& checks);

/// Returns lines of text that say where a model fails. The first line states the combined p value
/// of all tests of the residuals. One line follows for each test with p < 0.05. All tests of the
/// correlation between residuals of neighbouring conditions share one line.
std::vector<std::string> checks_table(const Checks& checks);

/// Returns a sentence on measurements that a model fits badly. The sentence names the (at most
/// three) measurements with the smallest p values, and states the number of further measurements.
/// Returns an empty text for no measurement, and for more than eight measurements, since the model
/// then fails as a whole.
/// @param measurements names of measurements, each with a p value [1]: probability that chance
///        alone causes at least the observed deviation from the model
std::string deviating_line(std::vector<std::pair<std::string, double>> measurements);

/// Returns lines of text that say where a model fails. The first lines state the significant tests
/// of the residuals. The last line names the conditions and files whose readings deviate most from
/// the model, if there are any.
std::vector<std::string> failure_table(const WhereItFails& where);

/// Returns a text for the user, "The recordings themselves show: ...", with up to two sentences on
/// faults of the recordings and the number of sentences left out. If the first fault explains most
/// of the misfit, the text states the share of the misfit that this fault explains. Empty if
/// `evidence` is empty.
std::string recordings_line(const std::vector<RecordingEvidence>& evidence);

}  // namespace pendular
