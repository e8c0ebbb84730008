#pragma once

#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "calib/emulator/known_runs.h"
#include "calib/fit/calibrate.h"
#include "calib/fit/calibration.h"
#include "calib/fit/reading_order.h"
#include "calib/model/predictor.h"
#include "sim/catalogue/resolved_study.h"
#include "sim/runs/ensemble.h"

namespace pendular {

/// Settings of a calibration (fit of a study's model, with simulations as needed).
struct CalibrationRequest {
    Fidelity fidelity;       ///< size, stiffness, slowest shear and strain of new simulations
    std::uint64_t seed = 1;  ///< seed from which the seeds of simulations follow
    bool profile = false;    ///< whether to compute the 68 % `profile_interval` of the friction
    /// Criteria for the end of the rounds of simulations and fits.
    CalibrationOptions options = {};
    /// Time limit of the simulations, except for the first simulations of a calibration that begins
    /// without earlier runs.
    RunBudget budget = {};
    /// Options for the lines of stress ratio of wet readings against 1/P*.
    CohesionOptions cohesion = {};
    /// Runs on which the emulator is trained at the beginning. If there are none and
    /// `KnownRuns::orders_more` is true, dry runs spread over friction and inertial number are
    /// simulated first.
    KnownRuns known = {};
    /// Callback before a further stage of simulations, with the name of the stage: "wet readings".
    std::function<void(std::string_view)> stage = {};
};

/// Calibrates a study: fits the parameters of its model to readings. The model uses an emulator
/// trained on earlier runs and on new runs that are simulated as needed. With fit_to = "dry" the
/// fit uses the dry readings, and the wet readings are predicted, unless an effect needs a joint
/// fit (`fitted_count`); with fit_to = "all" it uses all readings.
/// @param report called after each round of simulations and fit; may be empty
/// @throws InputError where there is no reading to fit, a reading cannot be simulated
///         (`check_range`), or the study lists effects on grains and there are no earlier runs
/// @throws std::invalid_argument where no earlier run can serve as a training run
/// @throws dem::SimulationError where none of the first dry or none of the first wet runs succeeds
Calibration calibrate_study(const ResolvedStudy& study, const Measurements& measurements,
                            const CalibrationRequest& request, const Workers& workers,
                            const CalibrationReport& report = {});

/// Checks that the conditions of all readings can be simulated with the settings `fidelity`.
/// @throws InputError at the first reading whose grains have a stiffness number below 300, whose
///         inertial number is above `dem::largest_inertial_number`, or whose reduced pressure or
///         liquid content is outside the range of simulations
void check_range(const std::vector<Reading>& readings, const Study& study,
                 const Fidelity& fidelity);

/// Number of readings that a study's calibration fits. They are the first of `readings`, in which
/// the dry readings must come first. All readings are fitted where fit_to = "all" or a listed
/// effect needs a joint fit of dry and wet readings (`needs_joint_fit`), else the dry readings.
std::size_t fitted_count(const ResolvedStudy& study, const std::vector<Reading>& readings);

/// Predicts shear stress [Pa] and solid fraction [1] at conditions that the calibration did not
/// fit, at its fitted parameters. The covariance includes the error of the fit: it is the model's
/// covariance plus J Cov(parameters) J', corrected for errors of the model that predictions and
/// fitted readings share (corrections, common runs) and for which the fit has already compensated.
/// Without shared errors and with a linear model, the chi2 of fitted and of predicted readings add
/// up to the chi2 of a joint fit.
Prediction predict_unseen(const Predictor& model, const Calibration& calibration,
                          const std::vector<Condition>& conditions);

/// Predicts shear stress [Pa] and solid fraction [1] of all readings of a calibration at its fitted
/// parameters. The covariance includes the error of the fit for readings that were not fitted
/// (`predict_unseen`).
Prediction predict_readings(const Predictor& model, const Calibration& calibration);

/// Fits the cohesion lines (stress ratio against 1/P*) of a calibration again, to its wet readings
/// and to the predictions of its wet readings, and replaces the calibration's lines and their
/// notes.
void draw_cohesion_lines(Calibration& calibration);

}  // namespace pendular
