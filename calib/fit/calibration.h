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
#include "sim/runs/run_settings.h"

namespace pendular {

/// Result of the calibration of a study, with the readings, settings and simulation runs that led
/// to it. Grains, liquid, model and effects are those of the study at the time of the fit.
struct Calibration {
    /// Dry readings, then wet readings, each in the order of `Measurements::readings`. The first
    /// `fitted` readings are fitted, all others only predicted.
    std::vector<Reading> readings;
    std::size_t fitted = 0;
    std::vector<DirectMeasurement> direct = {};  ///< used by the fit
    GrainProperties grains;
    std::optional<Liquid> liquid;
    ModelSettings model;
    std::vector<WrittenEffect> written_effects;  ///< by formulas ([[effect]] in study.toml)
    Fidelity fidelity;
    std::uint64_t seed = 1;  ///< from which the seeds of all simulations follow
    /// Whether there were no earlier runs: the emulator is trained on the calibration's own runs.
    bool cold = false;
    std::vector<Parameter> parameters;  ///< the first is the friction coefficient
    Fit fit;
    /// Predictions of all `readings` at the fitted parameters. For readings that were not fitted,
    /// the covariance includes the error of the fit (`predict_readings`).
    Prediction prediction;
    CohesionOptions cohesion;  ///< with which `cohesion_lines` were fitted
    /// Lines of the measured, then of the predicted stress ratios; empty in a dry study.
    std::vector<CohesionLine> cohesion_lines;
    /// Sentences for the user on groups of wet readings without a line, and on readings left out.
    std::vector<std::string> cohesion_notes;
    /// Rounds that led to the last fit, without those of a preceding fit to the dry readings.
    int rounds = 0;
    std::vector<dem::RunResult> runs;  ///< training runs, earlier and new
    std::size_t known = 0;             ///< number of earlier runs, the first of `runs`
    EmulatorHyperparameters hyperparameters;
    std::vector<SimulatedRuns> simulated;  ///< an entry for each reason
    /// 68 % interval of each parameter, in its unit (`profile_interval`), if requested; else empty.
    std::vector<std::pair<double, double>> profile;
    /// Sentences for the user that qualify the result (`notes_on`).
    std::vector<std::string> notes;
};

}  // namespace pendular
