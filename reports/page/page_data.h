#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "reports/page/page_curves.h"
#include "reports/page/page_recordings.h"
#include "workflow/switched_models.h"

namespace pendular {

/// JSON from which the page of a study draws its panels: the readings, the panels that show them,
/// and all combinations of switched effects. For each combination it contains the predictions as a
/// polynomial of second order in the shifts of the parameters from the fit. The page computes
/// curves, residuals, chi2 and RMS errors from this polynomial when a reader moves the parameters.
///
/// Arrays are base64 of little-endian numbers. The key `response` has two parts, for stress ratio
/// and solid fraction. Each part begins with the values at all points (the readings, then the
/// points of the curves) as 32-bit floats. For each coefficient of first and second order follow a
/// 32-bit float, the scale, and one 16-bit integer per point: the coefficient at the point is
/// integer x scale/32767, for parameters in units of their standard errors.
/// @param panels panels of the page; `models` must have predictions at the points of their curves,
///        in the order of `points_of_curves`
/// @param recordings courses of the study's recordings, which are drawn below the panels
nlohmann::ordered_json page_data(const SwitchedModels& models, const std::vector<PagePanel>& panels,
                                 const std::vector<PageRecording>& recordings);

}  // namespace pendular
