#pragma once

#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "calib/emulator/known_runs.h"
#include "calib/fit/calibrate.h"
#include "calib/fit/calibration.h"
#include "calib/fit/predicted_readings.h"
#include "calib/model/predictor.h"
#include "sim/catalogue/resolved_study.h"
#include "sim/runs/ensemble.h"

namespace pendular {

/// Settings of the calibration of a study.
struct CalibrationRequest {
    Fidelity fidelity;       ///< of the new simulations
    std::uint64_t seed = 1;  ///< from which the seeds of all simulations follow
    /// Whether to compute the 68 % interval of each parameter (`profile_interval`).
    bool profile = false;
    CalibrationOptions options = {};
    /// Time limit of simulations. If it ends during the first of them, the finished ones are used.
    RunBudget budget = {};
    CohesionOptions cohesion = {};
    /// Earlier runs. If there are none and `KnownRuns::may_simulate` is true, the calibration first
    /// simulates dry runs spread over friction coefficient and inertial number.
    KnownRuns known = {};
    /// Called with "wet readings" when the calibration begins to simulate for wet readings that are
    /// predicted but not fitted; may be empty.
    std::function<void(std::string_view)> stage = {};
};

/// Returns the calibration of a study's model to its readings. The emulator is trained on earlier
/// runs and on new runs, which are simulated as needed. If fit_to = "all" in study.toml or an
/// effect needs a joint fit (`needs_joint_fit`), all readings are fitted. Otherwise the dry
/// readings are fitted and the wet readings predicted.
/// @throws InputError if the study has no reading to fit, a reading cannot be simulated
///         (`check_range`), or the study lists effects on grains and there are no earlier runs
/// @throws std::invalid_argument if none of the earlier runs can serve as a training run
/// @throws dem::SimulationError if all of the first dry runs or all of the first wet runs fail
Calibration calibrate_study(const ResolvedStudy& study, const Measurements& measurements,
                            const CalibrationRequest& request, const Workers& workers,
                            const CalibrationReport& report = {});

/// Checks that simulations are possible at the conditions of all readings.
/// @throws InputError for the first reading whose grains have a stiffness number below 300, whose
///         inertial number is above `dem::largest_inertial_number`, or whose reduced pressure or
///         liquid content is outside the range of simulations
void check_range(const std::vector<Reading>& readings, const Study& study,
                 const Fidelity& fidelity);

/// Checks that a study has a reading.
/// @throws InputError if it has none, with the reason that the steps of its recordings share
void demand_readings(const Study& study, const Measurements& measurements);

/// Returns the number of readings, the first ones, that `calibrate_study` fits.
/// @param readings readings of the study, dry readings first
std::size_t fitted_count(const ResolvedStudy& study, const std::vector<Reading>& readings);

/// Returns a copy of the study with the setting fit_to = "all" of study.toml.
ResolvedStudy fitting_all(const ResolvedStudy& study);

/// Fits the cohesion lines of a calibration at one inertial number (`at_one_inertial_number`), in
/// place of its earlier lines and notes on them: first of the measured, then of the predicted
/// stress ratios. A study without wet readings has no lines.
/// @param model model of the calibration
void add_cohesion_lines(const Predictor& model, Calibration& calibration);

}  // namespace pendular
