#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "calib/emulator/query.h"
#include "calib/fit/cohesion_lines.h"
#include "calib/fit/fit.h"
#include "calib/model/run_planner.h"
#include "data/reading.h"
#include "data/study/study.h"
#include "sim/runs/fidelity.h"

namespace pendular {

/// Result of the calibration of a study: the fitted parameters and predictions, with the readings,
/// settings and simulation runs from which the calibration computed the parameters and predictions.
struct Calibration {
    /// Readings of the study. First come the dry readings, then the wet readings, each in the order
    /// of `Measurements::readings`. The first `fitted` readings are fitted, and all following
    /// readings are only predicted.
    std::vector<Reading> readings;
    /// Number of readings that the fit uses, which are the first readings in `readings`.
    std::size_t fitted = 0;
    /// Direct measurements of effects' parameters, such as the contact angle of a drop, which the
    /// fit uses in addition to the readings.
    std::vector<DirectMeasurement> direct = {};
    /// Properties of the study's grains at the time of the fit.
    GrainProperties grains;
    /// Liquid of the study at the time of the fit; empty if the study stated no liquid.
    std::optional<Liquid> liquid;
    /// Settings of the study's model at the time of the fit.
    ModelSettings model;
    /// Effects that the study defined by formulas ([[effect]] in study.toml) at the time of the
    /// fit.
    std::vector<WrittenEffect> written_effects;
    /// Fidelity of the simulations of the calibration: number of grains, stiffness number, lowest
    /// inertial number and strain.
    Fidelity fidelity;
    /// Random seed from which the seeds of all simulations of the calibration follow.
    std::uint64_t seed = 1;
    /// Whether the calibration began without earlier simulation runs, so that the emulator is
    /// trained on the calibration's own runs only.
    bool cold = false;
    /// Parameters of the model, of which the first is the friction coefficient.
    std::vector<Parameter> parameters;
    /// Result of the last fit of the model's parameters.
    Fit fit;
    /// Predicted shear stress [Pa] and solid fraction [1] of all `readings` at the fitted
    /// parameters. For readings that were not fitted, the covariance includes the error of the fit
    /// (`predict_unseen`).
    Prediction prediction;
    /// Options with which the lines in `cohesion_lines` were fitted.
    CohesionOptions cohesion;
    /// Straight lines of stress ratio against the inverse reduced pressure 1/P* of the wet
    /// readings. First come the lines fitted to the measured stress ratios, then the lines fitted
    /// to the predicted stress ratios. The list is empty in a dry study.
    std::vector<CohesionLine> cohesion_lines;
    /// Sentences for the user on groups of wet readings without a cohesion line, and on readings
    /// that a cohesion line leaves out.
    std::vector<std::string> cohesion_notes;
    /// Number of rounds of simulations and fits that led to the last fit. Rounds of a preceding fit
    /// to the dry readings alone are not counted.
    int rounds = 0;
    /// Simulation runs on which the emulator of the model is trained, earlier runs and new runs.
    std::vector<dem::RunResult> runs;
    /// Number of runs, the first ones of `runs`, that existed before the calibration.
    std::size_t known = 0;
    /// Hyperparameters of the emulator (amplitudes, correlation lengths and noise of the Gaussian
    /// processes) for each observable.
    EmulatorHyperparameters hyperparameters;
    /// Numbers of runs that were simulated for the calibration. There is an entry for each reason
    /// to simulate, such as "to confirm the optimum".
    std::vector<SimulatedRuns> simulated;
    /// Lower and upper end of the 68 % interval of the friction coefficient [1], from the profile
    /// likelihood (`profile_interval`); empty if the interval was not requested.
    std::optional<std::pair<double, double>> profile;
    /// Sentences for the user that qualify the result of the calibration (`notes_on`).
    std::vector<std::string> notes;
};

}  // namespace pendular
