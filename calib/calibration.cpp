#include "calib/calibration.h"

#include <fmt/format.h>

#include <algorithm>

#include "data/input_error.h"

namespace pendular {
namespace {

/// Lowest stiffness number at which the rigidity shift was measured (dem::rigidity_factor).
constexpr double softest_corrected = 300;

std::vector<Condition> conditions_of(const std::vector<Reading>& readings) {
    std::vector<Condition> conditions;
    for (const auto& reading : readings) {
        conditions.push_back(reading.condition);
    }
    return conditions;
}

/// @throws InputError where a reading is outside what can be simulated
void check_range(const std::vector<Reading>& readings, const Study& study) {
    for (const auto& reading : readings) {
        const auto kappa = stiffness_number(reading.condition.normal_stress, study.grains);
        if (kappa && *kappa < softest_corrected) {
            throw InputError(
                reading.origin,
                fmt::format(
                    "at {:.3g} Pa these beads have a stiffness number of {:.3g}; the correction "
                    "to the study's stiffness holds from {} on: check youngs_modulus and its unit",
                    reading.condition.normal_stress, *kappa, softest_corrected));
        }
        if (reading.condition.inertial_number > dem::largest_inertial_number) {
            throw InputError(
                reading.origin,
                fmt::format(
                    "inertial number {:.3g} is above {}, where beads no longer flow densely; "
                    "leave this reading out",
                    reading.condition.inertial_number, dem::largest_inertial_number));
        }
    }
}

std::vector<std::string> warnings(const Calibration& c) {
    std::vector<std::string> notes;
    const Eigen::MatrixXd corrections = c.fit.covariance - c.fit.measurement_part - c.fit.run_part;
    if (corrections(0, 0) > 0.3 * c.fit.covariance(0, 0)) {
        notes.push_back(fmt::format(
            "{:.0f} % of the variance comes from the corrections to the study's stiffness and to "
            "the quasi-static limit; a stiffer, slower fidelity lowers it",
            100 * corrections(0, 0) / c.fit.covariance(0, 0)));
    }
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
        const std::string why =
            measurements.excluded.empty()
                ? "give dry recordings or readings (liquid_content = 0)"
                : "all were left out, the first one for: " + measurements.excluded.front().reason;
        throw InputError({study.file.string()}, "there is no dry reading to fit; " + why);
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
    check_range(result.readings, study);
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
    result.grains = study.grains;
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
