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
/// settings and runs on which they are based.
struct Calibration {
    /// Readings of the study: the dry readings, then the wet readings, each in the order of the
    /// measurement. The first `fitted` readings are fitted, the others only predicted.
    std::vector<Reading> readings;
    /// Number of readings that the fit uses; they are the first of `readings`.
    std::size_t fitted = 0;
    /// Direct measurements of effects' parameters, which the fit uses in addition to the readings.
    std::vector<DirectMeasurement> direct = {};
    GrainProperties grains;        ///< grains of the study when it was fitted
    std::optional<Liquid> liquid;  ///< liquid of the study at the time of the fit
    ModelSettings model;           ///< model settings of the study when it was fitted
    /// Effects that the study defined by formulas ([[effect]] in study.toml) when it was fitted.
    std::vector<WrittenEffect> written_effects;
    /// Settings of the simulations of the calibration, such as the number of grains.
    Fidelity fidelity;
    /// Random seed from which the seeds of all simulations of the calibration follow.
    std::uint64_t seed = 1;
    /// Whether the calibration began without any earlier run on which to train its emulator.
    bool cold = false;
    std::vector<Parameter> parameters;  ///< parameters of the model; the first is the friction
    /// Result of the last fit of the model's parameters.
    Fit fit;
    /// Predicted shear stress [Pa] and solid fraction [1] of all `readings` at the fitted
    /// parameters. For readings that were not fitted, the covariance includes the error of the fit
    /// (`predict_unseen`).
    Prediction prediction;
    /// Options with which `cohesion_lines` were fitted.
    CohesionOptions cohesion;
    /// Straight lines of stress ratio against 1/P* (P*: reduced pressure) of the wet readings:
    /// lines fitted to the measured values, then lines fitted to the predicted values; empty in a
    /// dry study.
    std::vector<CohesionLine> cohesion_lines;
    /// Sentences for the user on groups of wet readings without a line, and on readings that a line
    /// leaves out.
    std::vector<std::string> cohesion_notes;
    /// Number of rounds of simulations and fits in the calibration.
    int rounds = 0;
    /// Simulation runs on which the model's emulator is trained.
    std::vector<dem::RunResult> runs;
    EmulatorHyperparameters hyperparameters;  ///< fitted hyperparameters of the emulator
    std::vector<SimulatedRuns>
        simulated;  ///< numbers of runs simulated for this calibration, by reason
    /// Lower and upper end of the 68 % interval of the friction coefficient [1]
    /// (`profile_interval`), if requested.
    std::optional<std::pair<double, double>> profile;
    /// Sentences for the user that qualify the result of the calibration (`notes_on`).
    std::vector<std::string> notes;
};

}  // namespace pendular
