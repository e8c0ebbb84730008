#include "calib/calibration.h"

#include <fmt/format.h>

#include <algorithm>

#include "data/input_error.h"

namespace pendular {
namespace {

std::vector<Condition> conditions_of(const std::vector<Reading>& readings) {
    std::vector<Condition> conditions;
    for (const auto& reading : readings) {
        conditions.push_back(reading.condition);
    }
    return conditions;
}

std::vector<std::string> warnings(const Calibration& c) {
    std::vector<std::string> notes;
    for (std::size_t k = 0; k < c.parameters.size(); ++k) {
        if (c.fit.at_bound[k]) {
            notes.push_back(fmt::format(
                "{} ended at the bound of its range, {:.3g} to {:.3g}: the readings ask for "
                "more than it can give",
                c.parameters[k].name, c.parameters[k].lower, c.parameters[k].upper));
        }
    }
    return notes;
}

}  // namespace

std::vector<Reading> fitted_readings(const Measurements& measurements) {
    std::vector<Reading> dry;
    std::ranges::copy_if(measurements.readings, std::back_inserter(dry),
                         [](const Reading& r) { return r.condition.dry(); });
    return dry;
}

Calibration calibrate_study(const Study& study, const Measurements& measurements,
                            const CalibrationRequest& request, const Workers& workers,
                            const CalibrationReport& report) {
    Calibration result{.readings = fitted_readings(measurements),
                       .fidelity = request.fidelity,
                       .seed = request.seed};
    if (result.readings.empty()) {
        throw InputError(
            {study.file.string()},
            "there is no dry reading to fit; give dry recordings or readings (liquid_content = 0)");
    }
    if (study.model.base != "dem") {
        throw InputError(
            {study.file.string()},
            fmt::format(
                "base = \"{}\" is a model of wet readings; dry ones are calibrated with base = "
                "\"dem\"",
                study.model.base));
    }
    if (study.model.fit_to == "all" && result.readings.size() < measurements.readings.size()) {
        throw InputError({study.file.string()},
                         "fit_to = \"all\" needs a model of wet readings; use fit_to = \"dry\"");
    }
    DirectSimulation model(study, conditions_of(result.readings), request.fidelity, request.seed,
                           workers);
    const Measured measured = stack(result.readings);
    result.fit = calibrate(model, measured, request.options, [&](int round, const Fit& fit) {
        result.rounds = round;
        if (report) {
            report(round, fit);
        }
    });
    result.parameters = model.parameters();
    result.surface_centre = model.centre();
    result.runs = model.runs();
    result.notes = model.notes();
    std::ranges::copy(warnings(result), std::back_inserter(result.notes));
    if (result.readings.size() < measurements.readings.size()) {
        result.notes.push_back(
            fmt::format("{} wet readings were not fitted: the friction comes from the dry ones",
                        measurements.readings.size() - result.readings.size()));
    }
    if (request.profile) {
        result.profile = profile_interval(model, measured, result.fit, 0);
    }
    return result;
}

DirectSimulation model_of(const Study& study, const Calibration& calibration) {
    DirectSimulation model(study, conditions_of(calibration.readings), calibration.fidelity,
                           calibration.seed, {});
    model.restore(calibration.runs, calibration.surface_centre);
    return model;
}

}  // namespace pendular
