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
    Fidelity fidelity;  ///< settings of new simulations: size, stiffness, slowest shear and strain
    /// Random seed from which the seeds of all simulations of the calibration follow.
    std::uint64_t seed = 1;
    /// Whether to compute the 68 % interval of the friction (`profile_interval`).
    bool profile = false;
    /// Criteria that end the rounds of simulations and fits.
    CalibrationOptions options = {};
    /// Time limit of all simulations of the calibration. If it ends during the first simulations,
    /// those that are finished by then are used.
    RunBudget budget = {};
    /// Options for the straight lines of stress ratio against 1/P* that are fitted to wet readings
    /// (P*: reduced pressure).
    CohesionOptions cohesion = {};
    /// Earlier runs, on which the emulator is trained at the beginning. If there are no earlier
    /// runs and `KnownRuns::orders_more` is true, dry runs spread over friction and inertial number
    /// are simulated first.
    KnownRuns known = {};
    /// Function that is called before a further stage of simulations, with the name of the stage:
    /// "wet readings".
    std::function<void(std::string_view)> stage = {};
};

/// Fits the parameters of a study's model to its readings. The model uses an emulator that is
/// trained on earlier runs and on new runs, which are simulated as needed. With fit_to = "dry" in
/// study.toml, the dry readings are fitted and the wet readings predicted, unless an effect needs a
/// joint fit (`needs_joint_fit`). With fit_to = "all", all readings are fitted.
/// @param report called after each round of simulations and fit; may be empty
/// @throws InputError if the study has no reading to fit, a reading cannot be simulated
///         (`check_range`), or the study lists effects on grains and there are no earlier runs
/// @throws std::invalid_argument if none of the earlier runs can serve as a training run
/// @throws dem::SimulationError if all of the first dry runs or all of the first wet runs fail
Calibration calibrate_study(const ResolvedStudy& study, const Measurements& measurements,
                            const CalibrationRequest& request, const Workers& workers,
                            const CalibrationReport& report = {});

/// Checks that the conditions of all readings can be simulated with the settings `fidelity`.
/// @throws InputError at the first reading whose grains have a stiffness number below 300, whose
///         inertial number is above `dem::largest_inertial_number`, or whose reduced pressure or
///         liquid content is outside the range of simulations
void check_range(const std::vector<Reading>& readings, const Study& study,
                 const Fidelity& fidelity);

/// Returns the number of readings that a calibration of the study fits. It fits all readings if
/// fit_to = "all" or a listed effect needs a joint fit of dry and wet readings (`needs_joint_fit`),
/// else the dry readings only.
/// @param readings readings of the study, dry readings first
std::size_t fitted_count(const ResolvedStudy& study, const std::vector<Reading>& readings);

/// Returns the study with all readings fitted together, as fit_to = "all" in study.toml does.
ResolvedStudy fitting_all(const ResolvedStudy& study);

/// Predicts shear stress [Pa] and solid fraction [1] at conditions that a calibration did not fit,
/// at its fitted parameters, for each condition in turn. The covariance includes the error of the
/// fit: it is the model's covariance plus J C J', with the covariance C of the parameters and the
/// derivatives J of the predictions with respect to the parameters. The covariance is corrected for
/// errors of the model that predictions and fitted readings share (corrections, common runs), since
/// the fit has already compensated for these errors. Without shared errors and with a linear model,
/// the chi2 of fitted and of predicted readings add up to the chi2 of a joint fit.
Prediction predict_unseen(const Predictor& model, const Calibration& calibration,
                          const std::vector<Condition>& conditions);

/// Predicts shear stress [Pa] and solid fraction [1] of all readings of a calibration at its fitted
/// parameters, for each reading in turn. For readings that were not fitted, the covariance includes
/// the error of the fit (`predict_unseen`); their covariance with fitted readings is set to 0.
Prediction predict_readings(const Predictor& model, const Calibration& calibration);

/// Fits the cohesion lines (straight lines of stress ratio against 1/P*, P*: reduced pressure) of a
/// calibration again and replaces its lines and their notes. Lines are fitted to the measured and
/// to the predicted wet readings; a study without wet readings has none.
void add_cohesion_lines(Calibration& calibration);

}  // namespace pendular
