#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "reports/page/page_curves.h"
#include "reports/page/page_recordings.h"
#include "workflow/switched_models.h"

namespace pendular {

/// Returns the JSON from which the page draws its panels: readings, panels, recordings, and a
/// fitted model for each combination of the effects that a reader can switch. The predictions of a
/// model are a polynomial of second order in the shifts of the parameters from the fit, in standard
/// errors.
///
/// The keys `response`, `errors`, `form` and `without` of a model are little-endian numbers as
/// base64. `response` contains, in this order:
/// - the predictions at all points (the readings, then the points of the curves) as 32-bit floats:
///   first the stress ratios, second the solid fractions
/// - the coefficients of first order, one for each parameter
/// - the coefficients of second order, one for each product of two parameters
///
/// A coefficient has a part for the stress ratio and a part for the solid fraction. Each part is a
/// scale (32-bit float) and one 16-bit integer per point; the coefficient is integer x scale/32767.
/// @param panels panels whose curve points `models` predicts, in the order of `points_of_curves`
nlohmann::ordered_json page_data(const SwitchedModels& models, const std::vector<PagePanel>& panels,
                                 const std::vector<PageRecording>& recordings);

}  // namespace pendular
