#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "calib/direct_simulation.h"
#include "calib/fit.h"
#include "data/reading.h"
#include "data/study.h"
#include "sim/fidelity.h"

namespace pendular {

/// The calibration of a study and everything it rests on.
struct Calibration {
    std::vector<Reading> readings;  ///< those fitted, in run order
    Grains grains;                  ///< those of the study when it was fitted
    Fidelity fidelity;
    std::uint64_t seed = 1;
    std::vector<Parameter> parameters;
    Fit fit;
    int rounds = 0;
    double surface_centre = 0;  ///< friction at which the response surface is centred
    std::vector<dem::RunResult> runs;
    std::optional<std::pair<double, double>> profile;  ///< of the friction, where asked for
    std::vector<std::string> notes;
};

struct CalibrationRequest {
    Fidelity fidelity;
    std::uint64_t seed = 1;
    bool profile = false;
    CalibrationOptions options = {};
};

/// Fits the study's parameters to its dry readings by direct simulation.
/// @throws InputError where there is nothing to fit
Calibration calibrate_study(const Study& study, const Measurements& measurements,
                            const CalibrationRequest& request, const Workers& workers,
                            const CalibrationReport& report = {});

/// The readings a calibration fits: the dry ones.
std::vector<Reading> fitted_readings(const Measurements& measurements);

/// The simulation model of a finished calibration, made again from its runs.
DirectSimulation model_of(const Study& study, const Calibration& calibration);

}  // namespace pendular
