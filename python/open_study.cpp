#include "python/open_study.h"

#include <utility>

#include "calib/fit/measured.h"
#include "data/input_error.h"
#include "workflow/json/diagnosis.h"
#include "workflow/json/fit.h"
#include "workflow/rivals.h"

namespace pendular::python {
namespace {

StudySettings with_folder(StudySettings settings, const std::filesystem::path& study) {
    if (settings.folder.empty()) settings.folder = study_folder(study) / "out";
    return settings;
}

/// The study with further effects, which its model lists.
StudyInput with_effects(StudyInput input, const std::vector<Effect>& effects) {
    if (effects.empty()) return input;
    Study study = input.study;
    for (const Effect& effect : effects)
        study.model.effects.push_back({effect.name, {study.file.string()}});
    input.study = ResolvedStudy(std::move(study), effects);
    return input;
}

/// Sentences on a diagnosis are for people, and reports writes them: Python has what they say.
DiagnosisTexts no_texts(const StudyDiagnosis& diagnosis) {
    return {.verdict = {},
            .proposals = std::vector<std::string>(diagnosis.proposals.size()),
            .to_do = {},
            .open = {}};
}

}  // namespace

OpenStudy::OpenStudy(const std::filesystem::path& study, StudySettings settings)
    : settings_(with_folder(std::move(settings), study)),
      input_(with_effects(
          read_input(study,
                     {settings_.folder, {"fit.json", "fit_runs.csv", "ladder.json"}, std::nullopt}),
          settings_.effects)) {}

RunStore* OpenStudy::store() const {
    if (settings_.store && getpid() != process_) {
        throw InputError(
            "the study was opened before this process was forked, and its store serves only the "
            "process that opened it; open the study in each process, or with store=False");
    }
    return settings_.store.get();
}

FitResult OpenStudy::result_of(const FittedStudy& fitted) const {
    const std::vector<ReadingMisfit>& readings = fitted.comparison.readings;
    Eigen::MatrixXd normalised(std::ssize(readings), 2);
    std::vector<int> lines;
    for (std::size_t k = 0; k < readings.size(); ++k) {
        normalised.row(static_cast<Eigen::Index>(k)) = readings[k].normalised;
        lines.push_back(readings[k].reading.origin.line);
    }
    return {.json = to_json(fitted.calibration, fitted.comparison, fitted.belief),
            .measured_covariance = stack(fitted.calibration.readings).covariance,
            .predicted_covariance = fitted.calibration.prediction.covariance,
            .normalised = std::move(normalised),
            .lines = std::move(lines),
            .of_means = input_.measurements.readings.size() > most_fitted};
}

Session OpenStudy::session(const std::stop_token& stop, const Listener& listener) const {
    return {input_,
            {.fidelity = settings_.fidelity,
             .seed = settings_.seed,
             .threads = settings_.threads,
             .store = store(),
             .training = nullptr,
             .stop = stop,
             .listener = listener},
            settings_.folder};
}

FitResult OpenStudy::calibrate(const FitOptions& fit, const std::stop_token& stop,
                               const Listener& listener) const {
    return result_of(session(stop, listener).calibrate(fit));
}

std::pair<nlohmann::ordered_json, FitResult> OpenStudy::compare(const std::stop_token& stop,
                                                                const Listener& listener) const {
    const FittedStudy compared = session(stop, listener).compare();
    return {to_json(compared, where_it_fails(compared, input_.measurements)), result_of(compared)};
}

Prediction OpenStudy::predict(const std::vector<Condition>& conditions, const std::stop_token& stop,
                              const Listener& listener) const {
    return session(stop, listener).predict(conditions);
}

StudyDiagnosis OpenStudy::diagnosis(std::optional<double> confirming_seconds,
                                    const Session& session) {
    StudyDiagnosis diagnosis = session.diagnose(confirming_seconds);
    const std::lock_guard lock(mutex_);
    explaining_ = explaining_sets(diagnosis);
    return diagnosis;
}

nlohmann::ordered_json OpenStudy::diagnose(std::optional<double> confirming_seconds,
                                           const std::stop_token& stop, const Listener& listener) {
    const StudyDiagnosis d = diagnosis(confirming_seconds, session(stop, listener));
    const Checks checks = checks_of(d, settings_.seed);
    const std::optional<ImpactTable> impacts =
        impacts_of(d, static_cast<std::size_t>(settings_.threads));
    return to_json(d, checks, impacts, input_.study, no_texts(d));
}

nlohmann::ordered_json OpenStudy::next(const std::stop_token& stop, const Listener& listener) {
    const Session own = session(stop, listener);
    const StudyDiagnosis d = diagnosis({}, own);
    return to_json(own.next(d), d, {});
}

nlohmann::ordered_json OpenStudy::change(Action action, const std::string& effect,
                                         const FitOptions& fit, const std::stop_token& stop,
                                         const Listener& listener) const {
    ChangeOptions options{.fit = fit, .same_fidelity = !settings_.fidelity_given};
    if (action == Action::add) {
        const std::lock_guard lock(mutex_);
        options.rivals = explaining_ ? rivals_among(*explaining_, effect)
                                     : rivals_in(settings_.folder / "diagnosis.json",
                                                 input_.study.study(), effect);
    }
    Session own = session(stop, listener);
    return to_json(action == Action::add ? own.add(effect, options) : own.drop(effect, options));
}

}  // namespace pendular::python
