#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "reports/page/page_curves.h"
#include "reports/page/page_recordings.h"
#include "workflow/switched_models.h"

namespace pendular {

/// Returns the JSON from which a study's HTML report draws its panels: readings (measured shear
/// stress and solid fraction), panels, recordings, and a fitted model for each combination of the
/// effects that a reader can switch on and off. The predictions of a model are a polynomial of
/// second order in the shifts of the parameters from the fit, in units of the standard errors.
///
/// The keys `response`, `errors`, `form` and `without` of a model contain little-endian numbers as
/// base64 text. The key `response` contains, in this order:
/// - the predictions at all points (the readings, then the points of the curves) as 32-bit floats:
///   first the stress ratios, second the solid fractions
/// - the coefficients of first order, one for each parameter
/// - the coefficients of second order, one for each product of two parameters
///
/// Each coefficient has two parts, first for the stress ratio, second for the solid fraction. Each
/// part is a scale as a 32-bit float and one 16-bit integer per point. The coefficient at a point
/// is integer x scale/32767.
/// @param panels panels of the report; `models` must have predictions at the points of the panels'
///        curves, in the order of `points_of_curves`
/// @param recordings recordings of the study, which the report draws below the panels
nlohmann::ordered_json page_data(const SwitchedModels& models, const std::vector<PagePanel>& panels,
                                 const std::vector<PageRecording>& recordings);

}  // namespace pendular
