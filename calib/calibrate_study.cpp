#include "calib/calibrate_study.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "calib/effect_model.h"
#include "calib/undetermined.h"
#include "data/input_error.h"
#include "sim/effect_catalogue.h"

namespace pendular {
namespace {

/// Lowest stiffness number at which the rigidity shift was measured (dem::rigidity_factor).
constexpr double softest_corrected = 300;

/// Below this reduced pressure the source saw the flow localise.
constexpr double uniform_reduced_pressure = 0.5;
/// Wet runs are made until the variance of their noise is no more than this part of the readings'.
constexpr double wet_noise_ratio = 0.4;
constexpr int most_wet_turns = 4;

/// @throws InputError where no bridge of the reading's liquid content can be simulated
void check_wet(const Reading& reading, const Study& study, const Fidelity& fidelity) {
    const Condition& condition = reading.condition;
    const double pressure = reduced_pressure(condition.normal_stress, study.grains, *study.liquid);
    // Bridges of a bead: 4 to 12 whatever friction, pressure and content, offsets of runs included.
    for (const double bridges : {4.0, 12.0}) {
        try {
            dem::check({.stiffness_number = fidelity.stiffness_number,
                        .wetting = dem::Wetting{pressure, dem::bridge_volume(
                                                              condition.liquid_content, bridges)},
                        .beads = fidelity.beads});
        } catch (const std::invalid_argument& error) {
            throw InputError(
                reading.origin,
                fmt::format("{:.3g} Pa (reduced pressure {:.3g}) and liquid content {:.3g} cannot "
                            "be simulated: {}; check their units and those of [liquid], or leave "
                            "this reading out",
                            condition.normal_stress, pressure, condition.liquid_content,
                            error.what()));
        }
    }
}

/// What was set aside because it cannot be right; empty if nothing was.
std::string set_aside(const Measurements& measurements) {
    const auto doubt = std::ranges::find_if(measurements.doubts, &Doubt::set_aside);
    return doubt == measurements.doubts.end()
               ? ""
               : "readings were set aside, the first for: " + doubt->what;
}

/// What to do about a study without any reading.
std::string why_no_reading(const Measurements& measurements) {
    if (std::string aside = set_aside(measurements); !aside.empty()) return aside;
    return measurements.excluded.empty()
               ? "give recordings or readings"
               : "all were left out, the first one for: " + measurements.excluded.front().reason;
}

/// @throws InputError where there is nothing to fit
void check_fitted(const Study& study, const Measurements& measurements, const Calibration& c) {
    if (c.fitted > 0) {
        return;
    }
    std::string why = why_no_reading(measurements);
    if (!c.readings.empty()) {
        why = "give dry recordings or readings (liquid_content = 0), or set fit_to = \"all\"";
        if (const std::string aside = set_aside(measurements); !aside.empty()) why += "; " + aside;
    }
    throw InputError({study.file.string()},
                     fmt::format("there is no {}reading to fit; {}",
                                 study.model.fit_to == "dry" ? "dry " : "", why));
}

/// What lowers the errors of a model whose runs know too little of the readings.
std::string remedy(const Calibration& c) {
    return c.scales && c.orders.empty()
               ? "fresh runs there help, which 'calibrate' and 'add --confirm' make"
               : "a higher fidelity helps";
}

std::size_t dry_count(const std::vector<Reading>& readings) {
    return static_cast<std::size_t>(
        std::ranges::count_if(readings, [](const Reading& r) { return r.condition.dry(); }));
}

/// Readings [from, to).
std::vector<Reading> part(const std::vector<Reading>& readings, std::size_t from, std::size_t to) {
    return {readings.begin() + static_cast<std::ptrdiff_t>(from),
            readings.begin() + static_cast<std::ptrdiff_t>(to)};
}

/// Says so where the model is less sure of the fitted readings than they are themselves.
std::optional<std::string> unsure_note(const Calibration& c) {
    const Measured readings = stack(part(c.readings, 0, c.fitted));
    const auto rms_percent = [&](const Eigen::MatrixXd& covariance, int first) {
        const Eigen::ArrayXd relative = covariance.diagonal().head(readings.value.size()).array() /
                                        readings.value.array().square();
        return 100 * std::sqrt(relative(Eigen::seq(first, Eigen::last, 2)).mean());
    };
    for (const auto& [first, observable] : {std::pair(0, "shear stress"), {1, "solid fraction"}}) {
        const double simulated = rms_percent(c.fit.prediction.run_noise, first),
                     measured = rms_percent(readings.covariance, first);
        if (simulated > measured) {
            return fmt::format(
                "the runs that are known tell the {} of the readings to {:.2g} %, they themselves "
                "to {:.2g} %: {}",
                observable, simulated, measured, remedy(c));
        }
    }
    return std::nullopt;
}

/// What a parameter at a bound of its range means: that an effect is not needed where the bound is
/// its neutral value, else that the readings ask for more than it can give.
std::string bound_note(const Parameter& parameter, double value, const Study& study,
                       const EffectCatalogue& catalogue) {
    const auto dot = parameter.name.rfind('.');
    const double close = 1e-6 * (parameter.upper - parameter.lower);
    if (dot != std::string::npos) {
        const std::string name = parameter.name.substr(0, dot);
        const Effect& effect = catalogue.find(name);
        const double neutral =
            effect.parameters[effect.parameter(parameter.name.substr(dot + 1))].neutral;
        // Without being listed it is on all the same, at what the study gives.
        const bool stays_on = effect.on_with_liquid && study.liquid;
        if (!stays_on && std::abs(value - neutral) <= close) {
            const auto folder = study.file.parent_path();
            return fmt::format(
                "The readings show no sign of {0}: {1} ended at {2:.3g}, where it has no effect, "
                "and is not needed. To leave it out: pendular drop {3} {0}",
                name, parameter.name, neutral, folder.empty() ? "." : folder.string());
        }
    }
    return fmt::format(
        "{} ended at the bound of its range, {:.3g} to {:.3g}: the readings ask for more than it "
        "can give",
        parameter.name, parameter.lower, parameter.upper);
}

std::vector<std::string> warnings(const Calibration& c, const Study& study) {
    std::vector<std::string> notes;
    if (const auto note = unsure_note(c)) {
        notes.push_back(*note);
    }
    const Eigen::MatrixXd corrections = c.fit.covariance - c.fit.measurement_part - c.fit.run_part;
    if (corrections(0, 0) > 0.3 * c.fit.covariance(0, 0)) {
        notes.push_back(fmt::format(
            "{:.0f} % of the variance comes from the corrections to the study's stiffness and to "
            "the quasi-static limit; a stiffer, slower fidelity lowers it",
            100 * corrections(0, 0) / c.fit.covariance(0, 0)));
    }
    const auto localised = std::ranges::count_if(c.readings, [&](const Reading& r) {
        return !r.condition.dry() && reduced_pressure(r.condition.normal_stress, c.grains,
                                                      *c.liquid) < uniform_reduced_pressure;
    });
    if (localised > 0) {
        notes.push_back(
            fmt::format("{} readings have a reduced pressure below {}, where wet beads tend to "
                        "shear in bands: neither cell nor simulation need be uniform there",
                        localised, uniform_reduced_pressure));
    }
    const EffectCatalogue catalogue(study);
    for (std::size_t k = 0; k < c.parameters.size(); ++k) {
        if (c.fit.at_bound[k]) {
            notes.push_back(bound_note(
                c.parameters[k], c.fit.parameters(static_cast<Eigen::Index>(k)), study, catalogue));
        }
    }
    return notes;
}

/// Fits the model to some readings.
Fit fit_to(const std::vector<Reading>& readings, const std::vector<DirectMeasurement>& direct,
           FlowModel& model, const CalibrationOptions& options, const CalibrationReport& report) {
    model.predict_for(conditions_of(readings));
    return calibrate(model, stack(readings, direct), options, report);
}

/// Wet runs until their noise is small beside the errors of the readings to predict.
/// @return whether it is
bool learn_wet(FlowModel& model, const Calibration& c) {
    const auto readings = part(c.readings, c.fitted, c.readings.size());
    const Eigen::VectorXd measured = stack(readings).covariance.diagonal();
    for (int turn = 0; turn < most_wet_turns; ++turn) {
        model.learn_wet(c.fit.parameters, 1);
        const Eigen::VectorXd noise =
            model.predict_conditions(c.fit.parameters, conditions_of(readings))
                .run_noise.diagonal();
        if (noise.cwiseQuotient(measured).mean() <= wet_noise_ratio) {
            return true;
        }
    }
    return false;
}

/// What direct measurements know of parameters: J' Sigma^-1 J.
Eigen::MatrixXd information_of(const std::vector<DirectMeasurement>& direct,
                               const std::vector<Parameter>& parameters) {
    const auto count = static_cast<Eigen::Index>(parameters.size());
    Eigen::MatrixXd information = Eigen::MatrixXd::Zero(count, count);
    for (const DirectMeasurement& each : direct) {
        if (const auto place = place_of(each, parameters)) {
            information(*place, *place) += 1 / (each.standard_error * each.standard_error);
        }
    }
    return information;
}

}  // namespace

void check_range(const std::vector<Reading>& readings, const Study& study,
                 const Fidelity& fidelity) {
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
        if (!reading.condition.dry()) {
            check_wet(reading, study, fidelity);
        }
    }
}

std::size_t fitted_count(const Study& study, const std::vector<Reading>& readings) {
    const EffectCatalogue catalogue(study);
    const bool all = study.model.fit_to == "all" || needs_joint_fit(catalogue.active(study));
    return all ? readings.size() : dry_count(readings);
}

std::vector<Reading> dry_first(const Measurements& measurements) {
    auto readings = measurements.readings;
    std::ranges::stable_partition(readings, [](const Reading& r) { return r.condition.dry(); });
    return readings;
}

Prediction predict_unseen(const FlowModel& model, const Calibration& c,
                          const std::vector<Condition>& conditions) {
    const auto seen = part(c.readings, 0, c.fitted);
    std::vector<Condition> all = conditions_of(seen);
    all.insert(all.end(), conditions.begin(), conditions.end());
    const Prediction both = model.predict_conditions(c.fit.parameters, all);
    const auto n = 2 * static_cast<Eigen::Index>(c.fitted);
    const Eigen::Index rest = both.value.size() - n;
    const Eigen::MatrixXd measured = stack(seen).covariance;
    const Eigen::MatrixXd weight = (measured + both.covariance.topLeftCorner(n, n)).inverse();
    // theta = K (y - f) + ..., so that errors e of the seen readings and d of all predictions make
    // an error J K (e - d_seen) + d_unseen.
    const Eigen::MatrixXd slopes = both.jacobian.bottomRows(rest) * c.fit.covariance;
    const Eigen::MatrixXd through_fit = slopes * both.jacobian.topRows(n).transpose() * weight;
    // Errors of the direct measurements come through the fit too.
    const Eigen::MatrixXd direct = information_of(c.direct, model.parameters());
    Eigen::MatrixXd map(rest, n + rest);
    map << -through_fit, Eigen::MatrixXd::Identity(rest, rest);
    return {.value = both.value.tail(rest),
            .jacobian = both.jacobian.bottomRows(rest),
            .covariance = map * both.covariance * map.transpose() +
                          through_fit * measured * through_fit.transpose() +
                          slopes * direct * slopes.transpose(),
            .run_noise = both.run_noise.bottomRightCorner(rest, rest)};
}

Prediction predict_readings(const FlowModel& model, const Calibration& c) {
    Prediction all = model.predict_conditions(c.fit.parameters, conditions_of(c.readings));
    if (c.fitted == c.readings.size()) {
        return all;
    }
    const auto fitted = 2 * static_cast<Eigen::Index>(c.fitted);
    const Eigen::Index rest = all.value.size() - fitted;
    all.covariance.topRightCorner(fitted, rest).setZero();
    all.covariance.bottomLeftCorner(rest, fitted).setZero();
    all.covariance.bottomRightCorner(rest, rest) =
        predict_unseen(model, c, conditions_of(part(c.readings, c.fitted, c.readings.size())))
            .covariance;
    return all;
}

void draw_cohesion_lines(Calibration& c) {
    c.cohesion_lines.clear();
    c.cohesion_notes.clear();
    if (dry_count(c.readings) == c.readings.size()) {
        return;
    }
    c.cohesion_lines =
        cohesion_lines(c.readings, c.grains, *c.liquid, c.cohesion, c.cohesion_notes);
    std::vector<std::string> same_notes;
    std::ranges::copy(
        cohesion_lines(c.readings, c.prediction, c.grains, *c.liquid, c.cohesion, same_notes),
        std::back_inserter(c.cohesion_lines));
}

Calibration calibrate_study(const Study& study, const Measurements& measurements,
                            const CalibrationRequest& request, const Workers& workers,
                            const CalibrationReport& report) {
    Calibration c{.readings = dry_first(measurements),
                  .grains = study.grains,
                  .liquid = study.liquid,
                  .model = study.model,
                  .written_effects = study.written_effects,
                  .fidelity = request.fidelity,
                  .seed = request.seed};
    c.fitted = fitted_count(study, c.readings);
    check_fitted(study, measurements, c);
    check_range(c.readings, study, c.fidelity);
    StudyModel study_model(study, conditions_of(c.readings), request.fidelity, request.seed,
                           workers, request.known);
    FlowModel& model = study_model.model();
    c.direct = study_model.direct();
    const auto counting = [&](int round, const Fit& fit) {
        c.rounds = round;
        if (report) {
            report(round, fit);
        }
    };
    CalibrationOptions options = request.options;
    const auto dry = part(c.readings, 0, dry_count(c.readings));
    if (c.fitted > dry.size() && !dry.empty() && model.parameters().size() == 1) {
        // Joint fits begin where the dry readings alone lead, so that wet runs are made there;
        // those of effects need not show in dry readings at all.
        options.start = fit_to(dry, c.direct, model, request.options, counting).parameters;
    }
    const auto fitted = part(c.readings, 0, c.fitted);
    c.fit = fit_to(fitted, c.direct, model, options, counting);
    bool wet_known = true;
    if (c.fitted < c.readings.size()) {
        if (request.stage) {
            request.stage("wet readings");
        }
        wet_known = learn_wet(model, c);
        if (request.known) {
            // An emulator learns of dry flow from wet runs too, and the friction with it.
            model.predict_for(conditions_of(fitted));
            c.fit = fit(model, stack(fitted, c.direct), c.fit.parameters);
        }
    }
    c.prediction = predict_readings(model, c);
    const SimulationModel& simulation = study_model.simulation();
    c.parameters = model.parameters();
    c.runs = simulation.runs();
    study_model.note_in(c);
    if (!wet_known) {
        c.notes.push_back(
            "the noise of the wet runs is not small beside the errors of the wet readings: their "
            "predictions are less sharp than the readings; " +
            remedy(c));
    }
    std::ranges::copy(simulation.notes(), std::back_inserter(c.notes));
    std::ranges::copy(warnings(c, study), std::back_inserter(c.notes));
    std::ranges::copy(undetermined(c.fit, c.parameters), std::back_inserter(c.notes));
    c.cohesion = request.cohesion;
    draw_cohesion_lines(c);
    if (request.profile) {
        model.predict_for(conditions_of(fitted));
        c.profile = profile_interval(model, stack(fitted, c.direct), c.fit, 0);
    }
    return c;
}

}  // namespace pendular
