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

/// The calibration of a study and everything it rests on.
struct Calibration {
    /// Dry ones first, then wet ones; each in run order. The first `fitted` are fitted, the others
    /// only predicted.
    std::vector<Reading> readings;
    std::size_t fitted = 0;
    std::vector<DirectMeasurement> direct = {};  ///< fitted too
    GrainProperties grains;                               ///< those of the study when it was fitted
    std::optional<Liquid> liquid;                ///< likewise
    ModelSettings model;                           ///< likewise
    std::vector<WrittenEffect> written_effects;  ///< likewise
    Fidelity fidelity;
    std::uint64_t seed = 1;
    bool cold = false;  ///< whether it began without any known run
    std::vector<Parameter> parameters;
    Fit fit;
    /// Predictions of all readings; readings that are predicted only follow `predict_unseen`.
    Prediction prediction;
    CohesionOptions cohesion;
    std::vector<CohesionLine> cohesion_lines;  ///< measured, then simulated; none where dry
    std::vector<std::string> cohesion_notes;   ///< which readings are on no line, and why
    int rounds = 0;
    std::vector<dem::RunResult> runs;                  ///< the model rests on
    EmulatorHyperparameters hyperparameters;                             ///< of the emulator behind it
    std::vector<Order> orders;                         ///< runs that were asked for
    std::optional<std::pair<double, double>> profile;  ///< of the friction, where asked for
    std::vector<std::string> notes;
};

}  // namespace pendular
