#include <fmt/format.h>

#include <Eigen/Core>
#include <cmath>
#include <optional>
#include <utility>

#include "analysis/diagnosis/diagnosis.h"
#include "calib/fit/measured.h"
#include "data/input_error.h"
#include "include/pendular/session.h"
#include "sim/dem/simulation_error.h"
#include "sim/runs/run_settings.h"
#include "sim/runs/store/run_store.h"
#include "workflow/rivals.h"
#include "workflow/session.h"

namespace pendular::v1 {
namespace {

/// Returns the result of `work`, with its exceptions converted to those of the public interface.
template <typename Work>
auto translated(const Work& work) {
    try {
        return work();
    } catch (const pendular::InputError& error) {
        throw InputError(error.what());
    } catch (const dem::Interrupted& error) {
        throw Interrupted(error.what());
    }
}

/// One line of text that describes an event.
std::string line_of(const Event& event) {
    switch (event.kind) {
        case Event::Kind::runs:
            return fmt::format("{}: {} of {} simulations", event.text, event.runs.runs_done,
                               event.runs.runs);
        case Event::Kind::round:
            return fmt::format("round {}: friction = {:.4g} +- {:.2g}", event.number,
                               event.fit->parameters(0), event.fit->standard_error(0));
        case Event::Kind::refits:
            return fmt::format("{}: {} of {}", event.text, event.number, event.total);
        default:
            return event.text;
    }
}

Reading reading_of(const pendular::Reading& reading) {
    return {.file = reading.origin.file,
            .step = static_cast<std::size_t>(reading.step),
            .normal_stress = reading.condition.normal_stress,
            .inertial_number = reading.condition.inertial_number,
            .liquid_content = reading.condition.liquid_content,
            .shear_stress = reading.value(0),
            .shear_stress_error = std::sqrt(reading.covariance(0, 0)),
            .solid_fraction = reading.value(1),
            .solid_fraction_error = std::sqrt(reading.covariance(1, 1))};
}

Fit fit_of(const Calibration& c, const Comparison& comparison, const Belief& belief) {
    Fit result{.parameters = {},
               .chi2 = comparison.total.chi2,
               .degrees_of_freedom = comparison.total.dof,
               .converged = c.fit.converged,
               .doubts = belief.reasons,
               .readings = {}};
    for (std::size_t k = 0; k < c.parameters.size(); ++k) {
        const auto place = static_cast<Eigen::Index>(k);
        result.parameters.push_back({.name = c.parameters[k].name,
                                     .unit = c.parameters[k].unit,
                                     .value = c.fit.parameters(place),
                                     .standard_error = c.fit.standard_error(place)});
    }
    for (std::size_t k = 0; k < comparison.readings.size(); ++k) {
        Reading reading = reading_of(comparison.readings[k].reading);
        reading.predicted_shear_stress = comparison.readings[k].predicted(0);
        reading.predicted_solid_fraction = comparison.readings[k].predicted(1);
        reading.fitted = k < c.fitted;
        result.readings.push_back(std::move(reading));
    }
    return result;
}

Change change_of(const ChangedStudy& changed) {
    return {
        .before =
            fit_of(changed.before.calibration, changed.before.comparison, changed.before.belief),
        .after = fit_of(changed.after.calibration, changed.after.comparison, changed.after.belief),
        .written = changed.written};
}

std::vector<Prediction> predictions_of(const std::vector<SetPoint>& at,
                                       const pendular::Prediction& prediction) {
    const Eigen::VectorXd error = prediction.covariance.diagonal().cwiseSqrt();
    std::vector<Prediction> result;
    for (std::size_t k = 0; k < at.size(); ++k) {
        const auto i = 2 * static_cast<Eigen::Index>(k);
        result.push_back({.at = at[k],
                          .shear_stress = prediction.value(i),
                          .shear_stress_error = error(i),
                          .solid_fraction = prediction.value(i + 1),
                          .solid_fraction_error = error(i + 1)});
    }
    return result;
}

NextReading reading_at(const Point& point, int repeats) {
    return {.at = {.normal_stress = point.condition.normal_stress,
                   .inertial_number = point.condition.inertial_number,
                   .liquid_content = point.condition.liquid_content},
            .direct = point.direct ? point.direct->parameter : "",
            .repeats = repeats};
}

Suggestion suggestion_of(const NextMeasurement& next) {
    Suggestion result;
    for (const FittedModel& rival : next.rivals) {
        result.rivals.push_back(rival.name);
    }
    for (const Series::Step& step : next.series.steps) {
        result.readings.push_back(reading_at(next.points[step.point], step.readings));
    }
    if (!next.sharpenings.empty()) {
        result.readings.push_back(
            reading_at(next.points[next.sharpenings.front().point], next.most_repeats));
    }
    return result;
}

}  // namespace

struct Session::Inside {
    FitOptions fit;
    std::optional<RunStore> store;
    std::optional<pendular::Session> session;
    EffectNames explaining;  ///< sets of effects that explain the readings (last diagnosis)

    StudyDiagnosis diagnose() {
        StudyDiagnosis diagnosis = session->diagnose();
        explaining = explaining_sets(diagnosis);
        return diagnosis;
    }
};

Session::Session(const std::filesystem::path& study, Options options)
    : inside_(std::make_unique<Inside>()) {
    translated([&] {
        Inside& inside = *inside_;
        inside.fit.confirm = options.confirm;
        SessionOptions how{.fidelity = fidelity_named(options.fidelity),
                           .seed = options.seed,
                           .threads = options.threads,
                           .stop = options.stop};
        if (options.listener) {
            how.listener = [tell = options.listener](const Event& event) { tell(line_of(event)); };
        }
        if (!options.store.empty()) {
            inside.store.emplace(options.store);
            how.store = &*inside.store;
        }
        inside.session.emplace(study, std::move(how),
                               OutputPlaces{.folder = options.results, .files = {}, .json = {}});
    });
}

Session::~Session() = default;
Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;

std::vector<Reading> Session::readings() const {
    std::vector<Reading> result;
    for (const pendular::Reading& reading : dry_first(inside_->session->measurements())) {
        result.push_back(reading_of(reading));
    }
    return result;
}

Fit Session::calibrate() const {
    return translated([&] {
        const FittedStudy result = inside_->session->calibrate(inside_->fit);
        return fit_of(result.calibration, result.comparison, result.belief);
    });
}

Fit Session::compare() const {
    return translated([&] {
        const FittedStudy result = inside_->session->compare();
        return fit_of(result.calibration, result.comparison, result.belief);
    });
}

std::vector<Prediction> Session::predict(const std::vector<SetPoint>& at) const {
    return translated([&] {
        std::vector<Condition> conditions;
        for (const SetPoint& point : at) {
            conditions.push_back({.normal_stress = point.normal_stress,
                                  .inertial_number = point.inertial_number,
                                  .liquid_content = point.liquid_content});
        }
        return predictions_of(at, inside_->session->predict(conditions));
    });
}

Verdict Session::diagnose() const {
    return translated([&] {
        const StudyDiagnosis d = inside_->diagnose();
        return Verdict{.verdict = std::string(to_string(d.diagnosis.verdict)),
                       .effects = d.diagnosis.effects,
                       .complete = d.diagnosis.complete,
                       .suspects = d.diagnosis.suspects,
                       .chi2 = d.diagnosis.base.fit.chi2,
                       .degrees_of_freedom = d.diagnosis.dof,
                       .doubts = d.belief.reasons};
    });
}

Suggestion Session::next() const {
    return translated([&] {
        const StudyDiagnosis diagnosis = inside_->diagnose();
        return suggestion_of(inside_->session->next(diagnosis));
    });
}

Change Session::add(const std::string& effect) {
    return translated([&] {
        const ChangedStudy changed = inside_->session->add(
            effect, {.fit = inside_->fit, .rivals = rivals_among(inside_->explaining, effect)});
        if (changed.written) inside_->explaining.clear();
        return change_of(changed);
    });
}

Change Session::drop(const std::string& effect) {
    return translated([&] {
        const ChangedStudy changed = inside_->session->drop(effect, {.fit = inside_->fit});
        if (changed.written) inside_->explaining.clear();
        return change_of(changed);
    });
}

}  // namespace pendular::v1
