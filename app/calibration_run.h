#pragma once

#include <optional>
#include <stop_token>

#include "app/console.h"
#include "app/options.h"
#include "calib/calibrate_study.h"
#include "calib/calibration.h"
#include "sim/store/run_store.h"

namespace pendular::app {

/// How many rounds a calibration takes: with known runs it is emulated and fresh runs at the
/// optimum confirm it, or none are made; by direct simulation one round more confirms it.
void choose_rounds(CalibrationRequest& request, std::optional<KnownRuns> known, bool confirm);

/// Calibrates with rounds and progress of the runs on standard error. Runs are kept in the store
/// where there is one; those that it has are used again if `reuse`.
/// @throws InputError as calibrate_study; dem::Interrupted with how to go on
Calibration run_calibration(Console& console, const CommonOptions& common, const Study& study,
                            const Measurements& measurements, CalibrationRequest request,
                            RunStore* store, bool reuse, std::stop_token stop);

}  // namespace pendular::app
