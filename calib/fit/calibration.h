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

/// Calibration of a study with the readings, settings and runs that it rests on.
struct Calibration {
    /// Readings, dry ones first, then wet ones, each in run order. The first `fitted` are fitted,
    /// the others only predicted.
    std::vector<Reading> readings;
    std::size_t fitted = 0;
    std::vector<DirectMeasurement> direct = {};  ///< direct measurements, which the fit uses too
    GrainProperties grains;                      ///< grains of the study when it was fitted
    std::optional<Liquid> liquid;                ///< likewise
    ModelSettings model;                         ///< likewise
    std::vector<WrittenEffect> written_effects;  ///< likewise
    Fidelity fidelity;
    std::uint64_t seed = 1;
    bool cold = false;  ///< whether it began without any training run
    std::vector<Parameter> parameters;
    Fit fit;
    /// Predictions of all readings; readings that are predicted only follow `predict_unseen`.
    Prediction prediction;
    CohesionOptions cohesion;
    std::vector<CohesionLine>
        cohesion_lines;  ///< measured lines, then simulated ones; empty in a dry study
    std::vector<std::string> cohesion_notes;  ///< readings that are on no line, with the reason
    int rounds = 0;
    std::vector<dem::RunResult> runs;         ///< training runs of the model
    EmulatorHyperparameters hyperparameters;  ///< hyperparameters of the emulator
    std::vector<Order> orders;  ///< simulations made for this calibration, with the reasons
    std::optional<std::pair<double, double>>
        profile;  ///< profile interval of the friction, if requested
    std::vector<std::string> notes;
};

}  // namespace pendular
