#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "calib/cohesion_lines.h"
#include "calib/emulated_simulation.h"
#include "calib/fit.h"
#include "data/reading.h"
#include "data/study.h"
#include "sim/fidelity.h"

namespace pendular {

/// The calibration of a study and everything it rests on.
struct Calibration {
    /// Dry ones first, then wet ones; each in run order. The first `fitted` are fitted, the others
    /// only predicted.
    std::vector<Reading> readings;
    std::size_t fitted = 0;
    std::vector<DirectMeasurement> direct = {};  ///< fitted too
    Grains grains;                               ///< those of the study when it was fitted
    std::optional<Liquid> liquid;                ///< likewise
    ModelChoice model;                           ///< likewise
    std::vector<WrittenEffect> written_effects;  ///< likewise
    Fidelity fidelity;
    std::uint64_t seed = 1;
    std::vector<Parameter> parameters;
    Fit fit;
    /// Of all readings; those only predicted as by `predict_unseen`.
    Prediction prediction;
    CohesionOptions cohesion;
    std::vector<CohesionLine> cohesion_lines;  ///< measured, then simulated; none where dry
    std::vector<std::string> cohesion_notes;   ///< which readings are on no line, and why
    int rounds = 0;
    double surface_centre = 0;             ///< friction at which the response surface is centred
    std::vector<dem::RunResult> runs;      ///< the model rests on
    std::optional<EmulatorScales> scales;  ///< of the emulator behind it; none: direct simulation
    std::vector<Order> orders;             ///< runs that the emulator asked for
    std::optional<std::pair<double, double>> profile;  ///< of the friction, where asked for
    std::vector<std::string> notes;
};

}  // namespace pendular
