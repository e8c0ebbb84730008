#pragma once

#include <Eigen/Core>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "analysis/misfit/believable.h"
#include "analysis/misfit/compare.h"
#include "analysis/misfit/recording_evidence.h"
#include "calib/fit/cohesion_lines.h"
#include "sim/catalogue/direct_measurement.h"

namespace pendular {

// Parts of the JSON output that several commands share.

/// Returns the JSON of a shear stress [Pa] and a solid fraction [1] with their standard errors.
/// @param covariance covariance matrix of the errors of `value`
nlohmann::ordered_json pair_of(const Eigen::Vector2d& value, const Eigen::Matrix2d& covariance);

/// Returns the JSON of chi2, its degrees of freedom and its p value, which is 1 if there are no
/// degrees of freedom.
nlohmann::ordered_json misfit_json(const Misfit& misfit);

/// Returns the JSON of one reading and its prediction: shear stress [Pa] and solid fraction [1]
/// with their standard errors, and the contribution of the reading to chi2.
nlohmann::ordered_json prediction_json(const ReadingMisfit& misfit);

/// Returns the JSON of a direct measurement: parameter, unit, value and standard error.
nlohmann::ordered_json direct_json(const DirectMeasurement& direct);

/// Adds the judgement whether a fit can be believed, as the keys `believable` and `reasons`.
void add_belief(nlohmann::ordered_json& json, const Belief& belief);

/// Returns the JSON of one fault of a file, with the lines concerned and what was done about it.
nlohmann::ordered_json file_finding_json(const Remark& fault);

/// Returns a JSON array of the faults found inside recordings, such as a wobble of the lid.
nlohmann::ordered_json findings_json(const std::vector<Remark>& findings);

/// Returns a JSON array of cohesion lines.
nlohmann::ordered_json cohesion_lines_json(const std::vector<CohesionLine>& lines);

/// Returns a JSON array of faults found inside recordings. `explains`: share of the misfit that the
/// fault explains [1], or null if it was not computed.
nlohmann::ordered_json recordings_json(const std::vector<RecordingEvidence>& evidence);

}  // namespace pendular
