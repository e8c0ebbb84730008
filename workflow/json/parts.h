#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "analysis/diagnosis/recording_evidence.h"
#include "analysis/misfit/believable.h"
#include "analysis/misfit/compare.h"
#include "calib/fit/cohesion_lines.h"
#include "sim/catalogue/effect.h"
#include "sim/catalogue/resolved_study.h"

namespace pendular {

using Json = nlohmann::ordered_json;

// Parts of JSON documents that several commands share.

/// Writes a JSON object to a file. The first key, "format", contains the version of the program's
/// JSON formats. The text goes to a temporary file, which is then renamed, so that an earlier file
/// is kept if the disk is full.
/// @throws std::runtime_error if the file cannot be written
void write_json(const std::filesystem::path& file, const Json& json);

/// Adds copies of some values under the names that they had in format 1. They go with format 3.
void add_older_names(Json& object);

/// Returns {"value": number, "stderr": standard error}, both in the unit of the number.
Json uncertain(double value, double error);

/// Returns the JSON of the parameter values of effects, in the units of the parameters, with keys
/// "EFFECT.PARAMETER", such as "torque-offset.torque".
Json effects_json(const std::vector<ActiveEffect>& effects);

/// Returns the JSON of a shear stress [Pa] and a solid fraction [1] with their standard errors.
/// @param covariance covariance matrix of the errors of `value`
Json pair_of(const Eigen::Vector2d& value, const Eigen::Matrix2d& covariance);

/// Returns the JSON of chi2, its degrees of freedom and its p value, which is 1 if there are no
/// degrees of freedom.
Json misfit_json(const Misfit& misfit);

/// Returns the JSON of one reading and its prediction: shear stress [Pa] and solid fraction [1]
/// with their standard errors, and the contribution of the reading to chi2.
Json prediction_json(const ReadingMisfit& misfit);

/// Returns the JSON of a direct measurement: parameter, unit, value and standard error.
Json direct_json(const DirectMeasurement& direct);

/// Adds the judgement whether a fit can be believed, as the keys `believable` and `reasons`.
void add_belief(Json& json, const Belief& belief);

/// Returns the JSON of one fault of a file, with the lines concerned and what was done about it.
Json file_finding_json(const Remark& fault);

/// Returns a JSON array of the faults found inside recordings, such as a wobble of the lid.
Json findings_json(const std::vector<Remark>& findings);

Json cohesion_lines_json(const std::vector<CohesionLine>& lines);

/// Returns a JSON array of faults found inside recordings. `explains`: share of the misfit that the
/// fault explains [1], or null if it was not computed.
Json recordings_json(const std::vector<RecordingEvidence>& evidence);

}  // namespace pendular
