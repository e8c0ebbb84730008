#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "reports/page/page_curves.h"
#include "reports/page/page_recordings.h"
#include "workflow/switched_models.h"

namespace pendular {

/// JSON of the readings of a study, the panels that show them, and all combinations of switched
/// effects with their expansions, from which a page computes curves, residuals, chi2 and RMS errors
/// of any combination and any parameters near its fit.
///
/// Arrays are base64 of little-endian numbers. `response` holds for (stress ratio, solid fraction):
/// the values at the K points (readings, then points of curves) as 32-bit floats, then for each
/// first- and second-order coefficient a scale (float) and K 16-bit integers in units of
/// scale/32767. Coefficients are for parameters in units of their standard errors.
/// @param panels panels of `page_panels`, whose curves the models were asked for
/// @param recordings recordings of the study
nlohmann::ordered_json page_data(const SwitchedModels& models, const std::vector<PagePanel>& panels,
                                 const std::vector<PageRecording>& recordings);

}  // namespace pendular
