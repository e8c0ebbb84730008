#pragma once

#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "calib/calibration.h"
#include "calib/study_model.h"

namespace pendular {

struct CalibrationRequest {
    Fidelity fidelity;
    std::uint64_t seed = 1;
    bool profile = false;
    CalibrationOptions options = {};
    CohesionOptions cohesion = {};
    /// Runs that an emulator is made of; none: by direct simulation alone.
    std::optional<KnownRuns> known = {};
    /// Called with the name of what is simulated next.
    std::function<void(std::string_view)> stage = {};
};

/// Fits the study's parameters by simulation, emulated where there are known runs: to its dry
/// readings, whereupon the wet ones are predicted (fit_to = "dry"), or to all (fit_to = "all").
/// @throws InputError where there is nothing to fit, or a reading is outside what can be simulated
Calibration calibrate_study(const Study& study, const Measurements& measurements,
                            const CalibrationRequest& request, const Workers& workers,
                            const CalibrationReport& report = {});

/// @throws InputError where a reading is outside what can be simulated
void check_range(const std::vector<Reading>& readings, const Study& study,
                 const Fidelity& fidelity);

/// The readings of a study in the order of a calibration: dry ones first.
std::vector<Reading> dry_first(const Measurements& measurements);
/// How many of them the study's calibration fits.
std::size_t fitted_count(const Study& study, const std::vector<Reading>& readings);

/// Predictions of conditions that the calibration did not fit, with its error: the model's
/// covariance plus J Cov(parameters) J', less what errors of the model that are common to them and
/// the fitted readings (corrections, shared runs) have already done through the fit. Where no such
/// errors are shared and the model is linear, the chi2 of fitted and of predicted readings add up
/// to that of a joint fit.
Prediction predict_unseen(const FlowModel& model, const Calibration& calibration,
                          const std::vector<Condition>& conditions);

/// Predictions of all readings of a calibration, with its error in those it did not fit.
Prediction predict_readings(const FlowModel& model, const Calibration& calibration);

/// Draws the cohesion lines of a calibration anew, through its wet readings and through their
/// predictions.
void draw_cohesion_lines(Calibration& calibration);

}  // namespace pendular
