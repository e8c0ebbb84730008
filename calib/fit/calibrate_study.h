#pragma once

#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "calib/emulator/known_runs.h"
#include "calib/fit/calibrate.h"
#include "calib/fit/calibration.h"
#include "calib/fit/predicted_readings.h"
#include "calib/fit/reading_order.h"
#include "calib/model/predictor.h"
#include "sim/catalogue/resolved_study.h"
#include "sim/runs/ensemble.h"

namespace pendular {

/// Settings of a calibration. A calibration fits the parameters of a study's model to the readings
/// and makes simulation runs as needed.
struct CalibrationRequest {
    /// Fidelity of the new simulations: number of grains, stiffness number, lowest inertial number
    /// and strain.
    Fidelity fidelity;
    /// Random seed from which the seeds of all simulations of the calibration follow.
    std::uint64_t seed = 1;
    /// Whether to compute the 68 % interval of the friction coefficient from the profile likelihood
    /// (`profile_interval`).
    bool profile = false;
    /// Stopping criteria and starting values of the calibration, which alternates between
    /// simulations and fits.
    CalibrationOptions options = {};
    /// Time limit of all simulations of the calibration. If the time ends during the first
    /// simulations, the simulations that are finished by then are used.
    RunBudget budget = {};
    /// Options for the cohesion lines: straight lines of stress ratio against the inverse reduced
    /// pressure 1/P* that are fitted to wet readings.
    CohesionOptions cohesion = {};
    /// Simulation runs that exist before the calibration and on which the emulator is trained. If
    /// there are no such runs and `KnownRuns::may_simulate` is true, the calibration first
    /// simulates dry runs spread over friction coefficient and inertial number.
    KnownRuns known = {};
    /// Function that is called when the calibration begins to simulate for wet readings that are
    /// predicted but not fitted. The argument is the name of this stage, "wet readings", for a
    /// message to the user. The function may be empty.
    std::function<void(std::string_view)> stage = {};
};

/// Fits the parameters of a study's model to the readings of the study. The emulator of the model
/// is trained on earlier runs and on new runs, which the function simulates as needed. If fit_to =
/// "all" in study.toml or an effect needs a joint fit (`needs_joint_fit`), all readings are fitted.
/// Otherwise the dry readings are fitted and the wet readings predicted.
/// @param report function that is called after each round of simulations and fit; may be empty
/// @throws InputError if the study has no reading to fit, a reading cannot be simulated
///         (`check_range`), or the study lists effects on grains and there are no earlier runs
/// @throws std::invalid_argument if none of the earlier runs can serve as a training run
/// @throws dem::SimulationError if all of the first dry runs or all of the first wet runs fail
Calibration calibrate_study(const ResolvedStudy& study, const Measurements& measurements,
                            const CalibrationRequest& request, const Workers& workers,
                            const CalibrationReport& report = {});

/// Checks that simulations with the settings `fidelity` are possible at the conditions (normal
/// stress, inertial number and liquid content) of all readings.
/// @throws InputError for the first reading whose grains have a stiffness number below 300, whose
///         inertial number is above `dem::largest_inertial_number`, or whose reduced pressure or
///         liquid content is outside the range of simulations
void check_range(const std::vector<Reading>& readings, const Study& study,
                 const Fidelity& fidelity);

/// Checks that a study has a reading.
/// @throws InputError if it has none, with the reason that the steps of its recordings share
void demand_readings(const Study& study, const Measurements& measurements);

/// Returns the number of readings that a calibration of the study fits. A calibration fits all
/// readings if fit_to = "all" or if a listed effect needs a joint fit of dry and wet readings
/// (`needs_joint_fit`). Otherwise a calibration fits the dry readings only.
/// @param readings readings of the study, dry readings first
std::size_t fitted_count(const ResolvedStudy& study, const std::vector<Reading>& readings);

/// Returns a copy of the study with the setting fit_to = "all" of study.toml. With this setting,
/// all readings are fitted together.
ResolvedStudy fitting_all(const ResolvedStudy& study);

/// Fits the cohesion lines of a calibration, and replaces the calibration's earlier lines and notes
/// on the lines. A cohesion line is a straight line of stress ratio against the inverse reduced
/// pressure 1/P*, for each liquid content, at one inertial number (`at_one_inertial_number`). The
/// lines of the measured stress ratios come first, then the lines of the predicted stress ratios. A
/// study without wet readings has no lines.
/// @param model model of the calibration
void add_cohesion_lines(const Predictor& model, Calibration& calibration);

}  // namespace pendular
