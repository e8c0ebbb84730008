#include "workflow/session.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "data/files/text_file.h"
#include "data/input_error.h"
#include "workflow/belief.h"
#include "workflow/confirm_diagnosis.h"
#include "workflow/fit_file.h"
#include "workflow/ladder_file.h"
#include "workflow/rival_effects.h"

namespace pendular {

namespace {

/// Places for output, with the session's default folder and files where none are given.
OutputPlaces with_own_files(const std::filesystem::path& study, OutputPlaces places) {
    if (places.folder.empty()) places.folder = study_folder(study) / "out";
    if (places.files.empty()) places.files = {"fit.json", "fit_runs.csv", "ladder.json"};
    return places;
}

}  // namespace

Session::Session(const std::filesystem::path& study, SessionOptions options, OutputPlaces outputs)
    : Session(read_input(study, with_own_files(study, outputs)), std::move(options),
              with_own_files(study, outputs).folder) {}

Session::Session(StudyInput input, SessionOptions options, std::filesystem::path folder)
    : options_(std::move(options)), folder_(std::move(folder)), input_(std::move(input)) {}

CalibratedStudy Session::calibrate(const FitOptions& fit) const {
    CalibratedStudy result{.calibration = fit_study(input_.study, measurements(), options_, fit),
                           .comparison = {},
                           .belief = {}};
    result.comparison = pendular::compare(result.calibration);
    result.belief = belief_in(input_.study, measurements(), result.calibration, result.comparison);
    write_calibration(folder_, result.calibration, result.comparison, result.belief);
    return result;
}

ComparedStudy Session::compare() const {
    demand_readings(study(), measurements());
    Calibration c =
        read_calibration(folder_ / "fit.json", input_.study, readings_to_fit(measurements()));
    StudyModel model(input_.study, c);
    check_parameters(c, model.model());
    c.prediction = predict_readings(model.model(), c);
    Comparison comparison = pendular::compare(c);
    add_cohesion_lines(model.model(), c);
    // The prediction is without errors of the fitted parameters, which the checks project out.
    WhereItFails where =
        where_it_fails(c.readings, measurements().scatter,
                       model.at(c.readings).predict(c.fit.parameters), c.parameters, c.direct);
    Belief belief = belief_in(input_.study, measurements(), c, comparison);
    return {std::move(c), std::move(model), std::move(comparison), std::move(where),
            std::move(belief)};
}

Prediction Session::predict(const std::vector<Condition>& conditions) const {
    const Calibration c =
        read_calibration(folder_ / "fit.json", input_.study, readings_to_fit(measurements()));
    std::vector<Reading> wanted;
    for (const Condition& condition : conditions) {
        wanted.push_back(
            {.origin = {"condition " + std::to_string(wanted.size() + 1)}, .condition = condition});
    }
    check_range(wanted, study(), c.fidelity);
    const StudyModel model(input_.study, c);
    check_parameters(c, model.model());
    return predict_unseen(model.model(), c, conditions);
}

StudyDiagnosis Session::diagnose(std::optional<double> confirming_seconds) const {
    const Ladder ladder = read_ladder(folder_ / "ladder.json");  // throws before any work
    StudyDiagnosis diagnosis =
        confirming_seconds
            ? confirm_diagnosis(input_.study, measurements(), options_, *confirming_seconds)
            : diagnose_study(input_.study, measurements(), options_);
    diagnosis.rivals = rivals_not_ruled_out(diagnosis, input_.study, ladder);
    return diagnosis;
}

NextMeasurement Session::next(const StudyDiagnosis& diagnosis) const {
    return next_measurement(input_.study, diagnosis);
}

ChangedStudy Session::add(const std::string& effect, const FitOptions& fit,
                          bool same_fidelity) const {
    return change(Action::add, effect, fit, same_fidelity);
}

ChangedStudy Session::drop(const std::string& effect, const FitOptions& fit,
                           bool same_fidelity) const {
    return change(Action::drop, effect, fit, same_fidelity);
}

ChangedStudy Session::change(Action action, const std::string& effect, const FitOptions& fit,
                             bool same_fidelity) const {
    if (read_text(study().file, largest_settings) != input_.text) {
        throw InputError({study().file.string()},
                         "has changed since it was read; nothing was written: give the same "
                         "command again, or open another session");
    }
    return change_study(input_.study, measurements(), action, effect, options_,
                        {.fit = fit, .same_fidelity = same_fidelity, .folder = folder_});
}

}  // namespace pendular
