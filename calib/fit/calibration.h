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

/// Calibration of a study: the fitted model, with the readings, settings and runs it is based on.
struct Calibration {
    /// Readings of the study: the dry readings, then the wet readings, each in run order. The first
    /// `fitted` readings are fitted, the others only predicted.
    std::vector<Reading> readings;
    /// Number of readings that the fit uses; they are the first of `readings`.
    std::size_t fitted = 0;
    std::vector<DirectMeasurement> direct = {};  ///< measured parameters of effects, fitted too
    GrainProperties grains;                      ///< grains of the study when it was fitted
    std::optional<Liquid> liquid;                ///< liquid of the study at the time of the fit
    ModelSettings model;                         ///< model settings of the study when it was fitted
    /// Effects that the study defined by formulas ([[effect]] in study.toml) when it was fitted.
    std::vector<WrittenEffect> written_effects;
    Fidelity fidelity;                  ///< set of simulation settings
    std::uint64_t seed = 1;             ///< seed from which the seeds of simulations follow
    bool cold = false;                  ///< whether the calibration began without any training run
    std::vector<Parameter> parameters;  ///< parameters of the model; the first is the friction
    Fit fit;                            ///< result of the last fit of `parameters`
    /// Predicted shear stress [Pa] and solid fraction [1] of all `readings` at the fitted
    /// parameters; the covariance of readings that were not fitted is that of `predict_unseen`.
    Prediction prediction;
    /// Options with which `cohesion_lines` were fitted.
    CohesionOptions cohesion;
    /// Lines of stress ratio against 1/P* of wet readings: fitted to measured, then to predicted
    /// values; empty in a dry study.
    std::vector<CohesionLine> cohesion_lines;
    /// Notes on groups of wet readings without a line, and on points that a line leaves out.
    std::vector<std::string> cohesion_notes;
    int rounds = 0;                           ///< number of rounds of simulations and fits
    std::vector<dem::RunResult> runs;         ///< training runs of the model
    EmulatorHyperparameters hyperparameters;  ///< fitted hyperparameters of the emulator
    std::vector<Order> orders;  ///< numbers of runs simulated for this calibration, by reason
    /// Lower and upper end of the 68 % interval of the friction [1] by `profile_interval`, if
    /// requested.
    std::optional<std::pair<double, double>> profile;
    std::vector<std::string> notes;  ///< notes for the user (`notes_on`)
};

}  // namespace pendular
