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
    /// Readings: the dry readings, then the wet readings, each in run order. The first `fitted`
    /// readings are fitted, the others only predicted.
    std::vector<Reading> readings;
    std::size_t fitted = 0;
    std::vector<DirectMeasurement> direct = {};  ///< direct measurements, which the fit uses too
    GrainProperties grains;                      ///< grains of the study when it was fitted
    std::optional<Liquid> liquid;                ///< liquid of the study when it was fitted
    ModelSettings model;                         ///< model settings of the study when it was fitted
    /// Effects that the user had written in the study when it was fitted.
    std::vector<WrittenEffect> written_effects;
    Fidelity fidelity;                  ///< settings of the simulations
    std::uint64_t seed = 1;             ///< seed from which the seeds of simulations follow
    bool cold = false;                  ///< whether the calibration began without any training run
    std::vector<Parameter> parameters;  ///< parameters of the model; the first is the friction
    Fit fit;                            ///< result of the last fit
    /// Predictions of all readings; the covariance of readings that were not fitted is that of
    /// `predict_unseen`.
    Prediction prediction;
    CohesionOptions cohesion;
    /// Measured cohesion lines, then simulated lines; empty in a dry study.
    std::vector<CohesionLine> cohesion_lines;
    std::vector<std::string> cohesion_notes;  ///< readings that are on no line, with the reason
    int rounds = 0;                           ///< number of rounds of simulations and fits
    std::vector<dem::RunResult> runs;         ///< training runs of the model
    EmulatorHyperparameters hyperparameters;  ///< hyperparameters of the emulator
    std::vector<Order> orders;  ///< simulations made for this calibration, with the reasons
    /// Profile interval of the friction [1], if requested.
    std::optional<std::pair<double, double>> profile;
    std::vector<std::string> notes;  ///< notes for the user (`notes_on`)
};

}  // namespace pendular
