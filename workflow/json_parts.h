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
nlohmann::ordered_json pair_of(const Eigen::Vector2d& value, const Eigen::Matrix2d& covariance);

/// JSON of the misfit of some readings: chi2, degrees of freedom and the p value of chi2, which is
/// 1 where there are no degrees of freedom.
nlohmann::ordered_json misfit_json(const Misfit& misfit);

/// JSON of a reading: its file, step and condition, shear stress and solid fraction as measured and
/// as predicted, and its part of chi2.
nlohmann::ordered_json prediction_json(const ReadingMisfit& misfit);

/// JSON of a direct measurement of a parameter: the parameter's name and unit, the measured value
/// and its standard error.
nlohmann::ordered_json direct_json(const DirectMeasurement& direct);

/// Adds the judgement whether a fit can be believed to the JSON of the fit, as the keys
/// `believable` and `reasons`.
void add_belief(nlohmann::ordered_json& json, const Belief& belief);

/// A finding on a file as an object: file, kind, lines, what is wrong, what was done.
nlohmann::ordered_json file_finding_json(const FileFinding& finding);

/// JSON array of the findings inside recordings, such as a wobble of the lid, with one object for
/// each finding.
nlohmann::ordered_json findings_json(const std::vector<RecordingFinding>& findings);

/// JSON array of cohesion lines (Mohr-Coulomb lines through measured or predicted wet readings).
nlohmann::ordered_json cohesion_lines_json(const std::vector<CohesionLine>& lines);

}  // namespace pendular
