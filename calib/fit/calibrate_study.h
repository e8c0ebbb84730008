#pragma once

#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "calib/emulator/known_runs.h"
#include "calib/fit/calibration.h"
#include "calib/fit/reading_order.h"
#include "calib/model/predictor.h"
#include "sim/catalogue/resolved_study.h"
#include "sim/runs/ensemble.h"

namespace pendular {

struct CalibrationRequest {
    Fidelity fidelity;
    std::uint64_t seed = 1;
    bool profile = false;
    CalibrationOptions options = {};
    CohesionOptions cohesion = {};
    /// Training runs at the beginning; without any, the planner simulates a first design.
    KnownRuns known = {};
    /// Callback with the name of the next simulations.
    std::function<void(std::string_view)> stage = {};
};

/// Fits the study's parameters by simulation, emulated from known and fresh runs: to its dry
/// readings, whereupon the wet ones are predicted (fit_to = "dry"), or to all (fit_to = "all").
/// @throws InputError where there is nothing to fit, or a reading is outside what can be simulated
Calibration calibrate_study(const ResolvedStudy& study, const Measurements& measurements,
                            const CalibrationRequest& request, const Workers& workers,
                            const CalibrationReport& report = {});

/// @throws InputError where a reading is outside what can be simulated
void check_range(const std::vector<Reading>& readings, const Study& study,
                 const Fidelity& fidelity);

/// Number of a study's readings, dry ones first, that its calibration fits.
std::size_t fitted_count(const ResolvedStudy& study, const std::vector<Reading>& readings);

/// Predictions of conditions that the calibration did not fit, with its error: the model's
/// covariance plus J Cov(parameters) J', less what errors of the model that are common to them and
/// the fitted readings (corrections, shared runs) have already done through the fit. Where no such
/// errors are shared and the model is linear, the chi2 of fitted and of predicted readings add up
/// to that of a joint fit.
Prediction predict_unseen(const Predictor& model, const Calibration& calibration,
                          const std::vector<Condition>& conditions);

/// Predictions of all readings of a calibration; the error of the fit is included for readings that
/// it did not fit.
Prediction predict_readings(const Predictor& model, const Calibration& calibration);

/// Draws the cohesion lines of a calibration anew, through its wet readings and through their
/// predictions.
void draw_cohesion_lines(Calibration& calibration);

}  // namespace pendular
