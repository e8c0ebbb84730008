#include "calib/fit/calibrate_study.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "calib/fit/calibration_notes.h"
#include "calib/fit/cohesion_lines.h"
#include "calib/fit/inexactness.h"
#include "calib/fit/measured.h"
#include "calib/fit/parameter_errors.h"
#include "calib/fit/predicted_readings.h"
#include "calib/fit/study_model.h"
#include "calib/model/run_planner.h"
#include "data/input_error.h"
#include "data/remarks/wording.h"
#include "sim/runs/run_request.h"

namespace pendular {

void demand_readings(const Study& study, const Measurements& measurements) {
    if (!measurements.readings.empty()) return;
    throw InputError({study.file.string()},
                     "The study has no reading. " + why_no_reading(measurements));
}

namespace {

/// Lowest stiffness number [1] at which the rigidity shift was measured (dem::rigidity_factor).
constexpr double softest_corrected = 300;

/// Largest ratio between the variance that the noise of wet runs causes in predictions and the
/// variance of the wet readings, at which no more wet runs are requested [1]. It enlarges an error
/// by sqrt(1.4) - 1 = 18 %, less than `largest_enlargement`.
constexpr double wet_noise_ratio = 0.4;
/// Largest number of rounds of wet runs: the first checks the emulator, each of the others halves
/// the variances of the predictions (`RunPlanner::improve_wet`).
constexpr int most_wet_turns = 4;

/// Checks that the bridges of a wet reading can be simulated.
/// @throws InputError where the reading's reduced pressure or liquid content is outside the range
///         of simulations
void check_wet(const Reading& reading, const Study& study, const Fidelity& fidelity) {
    const Condition& condition = reading.condition;
    const double reduced = reduced_pressure(condition.normal_stress, study.grains, *study.liquid);
    // A grain has 4 to 12 bridges at every friction, pressure and liquid content, including those
    // of planned runs.
    for (const double bridges : {4.0, 12.0}) {
        try {
            check_run({.stiffness_number = fidelity.stiffness_number,
                       .wetting = dem::Wetting{reduced, dem::bridge_volume(condition.liquid_content,
                                                                           bridges)},
                       .grains = fidelity.grains});
        } catch (const std::invalid_argument& error) {
            throw InputError(
                reading.origin,
                fmt::format("{:.3g} Pa (reduced pressure {:.3g}) and liquid content {:.3g} cannot "
                            "be simulated: {}; check their units and those of [liquid], or leave "
                            "this reading out",
                            condition.normal_stress, reduced, condition.liquid_content,
                            error.what()));
        }
    }
}

/// Clause on the readings and rows that `import` set aside as impossible, for messages; empty if
/// there are none.
std::string set_aside(const Measurements& measurements) {
    const auto doubts = measurements.with(Remark::Outcome::set_aside);
    return doubts.empty()
               ? ""
               : "readings were set aside; the reason for the first: " + text_of(doubts.front());
}

/// Checks that the calibration has readings to fit.
/// @throws InputError where it has none, with the reason
void check_fitted(const Study& study, const Measurements& measurements, const Calibration& c) {
    if (c.fitted > 0) {
        return;
    }
    demand_readings(study, measurements);
    std::string why =
        "give dry recordings or readings (liquid_content = 0), or set fit_to = \"all\"";
    if (const std::string aside = set_aside(measurements); !aside.empty()) why += "; " + aside;
    throw InputError({study.file.string()},
                     fmt::format("there is no {}reading to fit; {}",
                                 study.model.fit_to == "dry" ? "dry " : "", why));
}

/// Checks that effects on grains can be predicted.
/// @throws InputError where a study with effects on grains has no earlier runs
void check_effects(const std::vector<const Effect*>& effects, const CalibrationRequest& request) {
    const auto grains = std::ranges::find_if(effects, &Effect::of_grains);
    if (request.known.runs.empty() && grains != effects.end()) {
        throw InputError(
            fmt::format("a fit without earlier simulations cannot include effects on grains, such "
                        "as {}: leave out --cold",
                        (*grains)->name));
    }
}

/// Model of some readings, improved by the planner's runs.
class PlannedModel : public LearningModel {
  public:
    PlannedModel(const ResolvedStudy& study, RunPlanner& planner)
        : study_(study), planner_(planner), whole_(study, planner.simulation()) {}

    const StudyModel& whole() const { return whole_; }
    Fit fit_to(const std::vector<Reading>& readings, const CalibrationOptions& options,
               const CalibrationReport& report) {
        readings_ = readings;
        renew();
        return pendular::calibrate(*this, stack(readings, whole_.direct()), options, report);
    }
    Fit fit_again(const std::vector<Reading>& readings, const Eigen::VectorXd& start) const {
        return fit(whole_.at(readings), stack(readings, whole_.direct()), start);
    }
    void improve_wet(const Eigen::VectorXd& parameters, const std::vector<Reading>& readings) {
        planner_.improve_wet(parameters(0), truly_imposed(parameters, readings));
        renew();
    }

    const Model& model() const override { return *model_; }
    void improve(const Eigen::VectorXd& parameters, double excess) override {
        planner_.improve(parameters(0), truly_imposed(parameters, readings_), excess);
        renew();
    }
    bool confirmed() const override { return planner_.confirmed(); }
    bool exhausted() const override { return planner_.exhausted(); }

  private:
    std::vector<EffectiveCondition> truly_imposed(const Eigen::VectorXd& parameters,
                                                  const std::vector<Reading>& readings) const {
        return whole_.model().imposed(parameters, conditions_of(readings));
    }
    void renew() {
        whole_ = StudyModel(study_, planner_.simulation());
        model_.emplace(whole_.at(readings_));
    }

    const ResolvedStudy& study_;
    RunPlanner& planner_;
    StudyModel whole_;
    std::vector<Reading> readings_;
    std::optional<ModelOfReadings> model_;
};

/// Simulates wet runs until their noise is small compared with the errors of the readings to
/// predict.
/// @return whether the noise is small after at most `most_wet_turns` rounds
bool learn_wet(PlannedModel& model, const Calibration& c) {
    const auto readings = part(c.readings, c.fitted, c.readings.size());
    const Eigen::VectorXd measured = stack(readings).covariance.diagonal();
    for (int turn = 0; turn < most_wet_turns; ++turn) {
        model.improve_wet(c.fit.parameters, readings);
        const Eigen::VectorXd noise = model.whole()
                                          .model()
                                          .predict(c.fit.parameters, conditions_of(readings))
                                          .run_noise.diagonal();
        if (noise.cwiseQuotient(measured).mean() <= wet_noise_ratio) {
            return true;
        }
    }
    return false;
}

/// Text on the inertial number to which the readings of cohesion lines were brought: "at inertial
/// numbers from 0.01 to 0.03 are brought to the quasi-static limit".
std::string text_on_inertial_number(const ReadingsAtOneRate& at, double least, double greatest) {
    return fmt::format(
        "at inertial numbers from {:.2g} to {:.2g} are brought to {}", least, greatest,
        at.inertial_number == 0 ? "the quasi-static limit"
                                : fmt::format("the inertial number {:.3g}", at.inertial_number));
}

/// Highest inertial number that was simulated [1]; 0 without simulations.
double fastest_run(const std::vector<dem::RunResult>& runs) {
    double fastest = 0;
    for (const dem::RunResult& run : runs)
        fastest = std::max(fastest, run.parameters.inertial_number);
    return fastest;
}

/// Note that readings of the cohesion lines were changed; empty if none was.
std::optional<std::string> note_on_moved(const ReadingsAtOneRate& at, const Calibration& c) {
    double least = INFINITY, greatest = 0;
    int count = 0;
    for (std::size_t k = 0; k < at.readings.size(); ++k) {
        const Condition& recorded = c.readings[k].condition;
        if (!at.moved[k] || recorded.dry() || recorded.at_failure) continue;
        least = std::min(least, recorded.inertial_number);
        greatest = std::max(greatest, recorded.inertial_number);
        ++count;
    }
    if (count == 0) return {};
    const bool apart = !agree(least, greatest, inertial_number_tolerance) ||
                       !agree(greatest, at.inertial_number, inertial_number_tolerance);
    const double fastest = fastest_run(c.runs);
    return fmt::format(
        "For the cohesion, {} wet readings {}{}{} by the difference of the model's predictions, "
        "whose error is included{}",
        count, apart ? text_on_inertial_number(at, least, greatest) : "",
        apart && at.ideal_instrument ? " and " : "",
        at.ideal_instrument ? "are freed of what the effects of the instrument add" : "",
        fastest > 0 && at.inertial_number > fastest
            ? fmt::format(", but not that of extrapolating: {:.2g} is the highest inertial number "
                          "that was simulated",
                          fastest)
            : "");
}

}  // namespace

void check_range(const std::vector<Reading>& readings, const Study& study,
                 const Fidelity& fidelity) {
    for (const auto& reading : readings) {
        const auto kappa = stiffness_number(reading.condition.normal_stress, study.grains);
        if (kappa && *kappa < softest_corrected) {
            throw InputError(
                reading.origin,
                fmt::format("at {:.3g} Pa these grains have a stiffness number of {:.3g}; the "
                            "correction to the study's stiffness is valid only from {} upwards: "
                            "check youngs_modulus and its unit",
                            reading.condition.normal_stress, *kappa, softest_corrected));
        }
        if (reading.condition.inertial_number > dem::largest_inertial_number) {
            throw InputError(
                reading.origin,
                fmt::format(
                    "inertial number {:.3g} is above {}, where grains no longer flow densely; "
                    "leave this reading out",
                    reading.condition.inertial_number, dem::largest_inertial_number));
        }
        if (!reading.condition.dry()) {
            check_wet(reading, study, fidelity);
        }
    }
}

std::size_t fitted_count(const ResolvedStudy& study, const std::vector<Reading>& readings) {
    const bool all = study.study().model.fit_to == "all" || needs_joint_fit(study.effects());
    return all ? readings.size() : dry_count(readings);
}

ResolvedStudy fitting_all(const ResolvedStudy& study) {
    Study changed = study;
    changed.model.fit_to = "all";
    return study.changed_to(std::move(changed));
}

void add_cohesion_lines(const Predictor& model, Calibration& c) {
    c.cohesion_lines.clear();
    c.cohesion_notes.clear();
    if (dry_count(c.readings) == c.readings.size()) {
        return;
    }
    const ReadingsAtOneRate at = at_one_inertial_number(model, c);
    c.cohesion_lines = cohesion_lines(at.readings, at.measured, c.grains, *c.liquid, c.cohesion,
                                      &c.cohesion_notes);
    if (c.cohesion_lines.empty()) return;
    std::ranges::copy(cohesion_lines(at.readings, at.simulated(), c.grains, *c.liquid, c.cohesion),
                      std::back_inserter(c.cohesion_lines));
    if (auto note = note_on_moved(at, c)) c.cohesion_notes.push_back(*note);
}

Calibration calibrate_study(const ResolvedStudy& resolved, const Measurements& measurements,
                            const CalibrationRequest& request, const Workers& workers,
                            const CalibrationReport& report) {
    const Study& study = resolved;
    Calibration c{.readings = readings_to_fit(measurements),
                  .grains = study.grains,
                  .liquid = study.liquid,
                  .model = study.model,
                  .written_effects = study.written_effects,
                  .fidelity = request.fidelity,
                  .seed = request.seed,
                  .cold = request.known.runs.empty()};
    c.fitted = fitted_count(resolved, c.readings);
    check_fitted(study, measurements, c);
    check_range(c.readings, study, c.fidelity);
    check_effects(resolved.effects(), request);
    RunPlanner planner(study, conditions_of(c.readings), request.fidelity, request.seed, workers,
                       request.known, request.budget);
    PlannedModel model(resolved, planner);
    c.direct = resolved.direct();
    const auto counting = [&](int round, const Fit& fit) {
        c.rounds = round;
        if (report) {
            report(round, fit);
        }
    };
    CalibrationOptions options = request.options;
    const auto dry = part(c.readings, 0, dry_count(c.readings));
    c.parameters = model.whole().model().parameters();
    if (c.fitted > dry.size() && !dry.empty() && c.parameters.size() == 1) {
        // A joint fit of friction alone begins at the optimum of the dry readings, so that wet runs
        // are made there. With effects it does not, as dry readings need not determine them.
        options.start = model.fit_to(dry, request.options, counting).parameters;
    }
    const auto fitted = part(c.readings, 0, c.fitted);
    c.fit = model.fit_to(fitted, options, counting);
    bool wet_known = true;
    if (c.fitted < c.readings.size()) {
        if (request.stage) {
            request.stage("wet readings");
        }
        wet_known = learn_wet(model, c);
        // The emulator learns about dry flow from wet runs too, which also changes the friction.
        c.fit = model.fit_again(fitted, c.fit.parameters);
    }
    if (!study.model.discrepancy_stated)
        c.fit.inexactness =
            likely_inexactness(stack(fitted, c.direct), c.fit.prediction, c.fit.at_bound).factor;
    add_instrument(c.fit, model.whole().model(), fitted, c.direct);
    c.prediction = predict_readings(model.whole().model(), c);
    const Emulator& emulator = planner.simulation()->emulator();
    c.runs = emulator.runs();
    c.known = request.known.runs.size();
    c.hyperparameters = emulator.hyperparameters();
    c.simulated = planner.simulated();
    c.notes = notes_on(c, resolved, planner, wet_known);
    if (auto note = note_on_means(c.readings.size(), measurements.readings.size()))
        c.notes.push_back(std::move(*note));
    c.cohesion = request.cohesion;
    add_cohesion_lines(model.whole().model(), c);
    if (request.profile) {
        // The covariance of a fit lacks the widening for few replicates and for more than the
        // expected discrepancy; with them, chi2 of a parabola rises by this much over one standard
        // error.
        for (Eigen::Index k = 0; k < c.fit.parameters.size(); ++k) {
            const double rise = std::pow(c.fit.standard_error(k), 2) / c.fit.covariance(k, k);
            c.profile.push_back(profile_interval(model.whole().at(fitted), stack(fitted, c.direct),
                                                 c.fit, k, rise));
        }
    }
    return c;
}

}  // namespace pendular
