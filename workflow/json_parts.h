#pragma once

#include <Eigen/Core>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "analysis/misfit/believable.h"
#include "analysis/misfit/compare.h"
#include "calib/fit/cohesion_lines.h"
#include "data/recordings/findings/file_finding.h"
#include "data/recordings/findings/finding.h"
#include "sim/catalogue/direct_measurement.h"

namespace pendular {

// Parts of JSON that several commands share.

/// JSON of a shear stress [Pa] and a solid fraction [1], each with its standard error.
/// @param covariance covariance of the errors of the two values
nlohmann::ordered_json pair_of(const Eigen::Vector2d& value, const Eigen::Matrix2d& covariance);

/// JSON of the misfit of some readings: chi2, degrees of freedom and the p value of chi2, which is
/// 1 where there are no degrees of freedom.
nlohmann::ordered_json misfit_json(const Misfit& misfit);

/// JSON of one reading and its prediction: file, step and condition of the reading, shear stress
/// [Pa] and solid fraction [1] as measured and as predicted with their standard errors, and the
/// part of chi2 that the reading contributes.
nlohmann::ordered_json prediction_json(const ReadingMisfit& misfit);

/// JSON of a direct measurement (a measurement of an effect's parameter without shearing grains):
/// name and unit of the parameter, measured value and its standard error.
nlohmann::ordered_json direct_json(const DirectMeasurement& direct);

/// Adds the judgement whether a fit can be believed to the JSON of the fit, as the keys
/// `believable` and `reasons`.
void add_belief(nlohmann::ordered_json& json, const Belief& belief);

/// JSON of one irregularity found in a file: the file, the kind of irregularity, the lines
/// concerned, what is wrong, and what was done about it.
nlohmann::ordered_json file_finding_json(const FileFinding& finding);

/// JSON array of the irregularities found inside recordings, such as a wobble of the lid; one
/// object for each.
nlohmann::ordered_json findings_json(const std::vector<RecordingFinding>& findings);

/// JSON array of cohesion lines, one object for each. A cohesion line is a Mohr-Coulomb line
/// through the measured or the predicted wet readings of one liquid content.
nlohmann::ordered_json cohesion_lines_json(const std::vector<CohesionLine>& lines);

}  // namespace pendular
